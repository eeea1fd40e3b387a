#include "eval/figures/change_pictures.h"

#include <algorithm>

#include "eval/metrics/brightness_change.h"
#include "eval/pictures/difference_picture.h"
#include "eval/pictures/format.h"
#include "events/sensor.h"

namespace saccade::eval {
namespace {

// Events of this one interval, ON minus OFF per pixel. One seed: every column has the same phases.
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

GridPicture picture(const ImageF& plane, float scale, const std::string& caption) {
  return {caption, plane.width(), plane.height(), signedPicture(plane, scale)};
}

template <class... Values>
std::string caption(const Score* score, const char* pattern, Values... values) {
  return score ? format(pattern, score->*values...) : "";
}

}  // namespace

ChangePictures::ChangePictures(const IntensityChange& reference, float bias, double threshold)
    : bias_(bias),
      threshold_(threshold),
      scale_dI_(colorScale(reference.dI)),
      scale_dL_(colorScale(brightnessChange(reference, bias))) {}

void ChangePictures::add(const std::string& name, const IntensityChange& change, const Score* s) {
  constexpr float kFullColor = 2;  // events
  names_.push_back(name);
  rows_[0].push_back(
      picture(change.dI, scale_dI_, caption(s, "L1 %.3f, MAPE %.3f", &Score::dI_l1, &Score::dI_mape)));
  rows_[1].push_back(picture(brightnessChange(change, bias_), scale_dL_,
                             caption(s, "L1 %.3f, MAPE %.3f", &Score::dL_l1, &Score::dL_mape)));
  rows_[2].push_back(
      picture(eventBalance(change, bias_, threshold_), kFullColor,
              caption(s, "false %.4f, missed %.4f", &Score::false_events, &Score::missed_events)));
}

std::string ChangePictures::draw() const {
  return drawPictureGrid(names_, {"dI", "dL", "events"}, rows_);
}

}  // namespace saccade::eval
