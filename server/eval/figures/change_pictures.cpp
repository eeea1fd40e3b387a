#include "eval/figures/change_pictures.h"

#include <algorithm>

#include "eval/metrics/brightness_change.h"
#include "eval/pictures/signed_picture.h"
#include "eval/pictures/text.h"
#include "eval/pictures/tone_map.h"
#include "events/sensor.h"

namespace saccade::eval {
namespace {

// Events of this interval, ON minus OFF per pixel. All columns have one seed, so the same threshold phases.
ImageF eventBalance(const IntensityChange& change, float bias, double threshold) {
  const SensorConfig config{.threshold = threshold,
                            .threshold_off = threshold,
                            .bias = bias,
                            .model = "probabilistic",
                            .reconstruction = "direct"};
  Sensor sensor(config, change.dI.width(), change.dI.height());
  SensorOutput out;
  sensor.generate(change, out);
  ImageF balance(change.dI.width(), change.dI.height());
  for (const Event& e : out.events) balance.at(e.x, e.y) += e.p ? 1.f : -1.f;
  return balance;
}

constexpr float kFullColor = 2;  // events

}  // namespace

ChangePictures::ChangePictures(const IntensityChange& reference, float bias, double threshold)
    : bias_(bias),
      threshold_(threshold),
      exposure_(exposureOf(reference.I_now)),
      scale_dI_(colorScale(reference.dI)),
      scale_dL_(colorScale(brightnessChange(reference, bias))) {}

void ChangePictures::add(const std::string& name, const IntensityChange& change, const Captions& captions) {
  names_.push_back(name);
  rows_[0].push_back(greyPicture(change.I_now, exposure_));
  rows_[1].push_back(signedPicture(change.dI, scale_dI_, captions[0]));
  rows_[2].push_back(signedPicture(brightnessChange(change, bias_), scale_dL_, captions[1]));
  rows_[3].push_back(signedPicture(eventBalance(change, bias_, threshold_), kFullColor, captions[2]));
}

void ChangePictures::addMethod(const std::string& name, const IntensityChange& change, const Score& s) {
  add(name, change,
      {format("L1 %.3f, MAPE %.3f", s.dI_l1, s.dI_mape), format("L1 %.3f, MAPE %.3f", s.dL_l1, s.dL_mape),
       format("false %.4f, missed %.4f", s.false_events, s.missed_events)});
}

void ChangePictures::addReference(const std::string& name, const IntensityChange& change, double error) {
  add(name, change, {format("own error: L1 %.3f", error), "", ""});
}

std::string ChangePictures::draw() const {
  const auto row = [](const char* what, float scale) {
    return format("%s, full colour %.3g", what, static_cast<double>(scale));
  };
  return drawPictureGrid(
      names_, {"picture", row("dI", scale_dI_), row("dL", scale_dL_), row("ON - OFF events", kFullColor)},
      rows_, kChangeKey);
}

}  // namespace saccade::eval
