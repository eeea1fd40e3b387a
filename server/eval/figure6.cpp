#include "eval/figure6.h"

#include <algorithm>
#include <cstdio>

#include "eval/difference_picture.h"
#include "events/log_response.h"
#include "events/sensor.h"

namespace saccade {
namespace {

ImageF brightnessChange(const IntensityChange& change, float bias) {
  ImageF dL(change.dI.width(), change.dI.height());
  logResponse(change, bias, dL);
  return dL;
}

// Events of this one interval, ON minus OFF per pixel. One seed: every column has the same phases.
ImageF eventBalance(const IntensityChange& change, float bias, double threshold) {
  Sensor sensor({.threshold = threshold, .threshold_off = threshold, .bias = bias, .model = "probabilistic"},
                change.dI.width(), change.dI.height());
  SensorOutput out;
  sensor.generate(change, out);
  ImageF balance(change.dI.width(), change.dI.height());
  for (const Event& e : out.events) balance.at(e.x, e.y) += e.p ? 1.f : -1.f;
  return balance;
}

Page::Cell draw(const ImageF& plane, float scale, const char* what, double value) {
  Page::Cell cell{
      {}, plane.width(), plane.height(), signedPicture(plane, scale), std::max(1, 256 / plane.width())};
  char caption[64];
  std::snprintf(caption, sizeof caption, "%s %.3g", what, value);
  if (value >= 0) cell.caption = caption;
  return cell;
}

}  // namespace

Figure6::Figure6(const IntensityChange& reference, float bias, double threshold)
    : bias_(bias),
      threshold_(threshold),
      scale_dI_(colorScale(reference.dI)),
      scale_dL_(colorScale(brightnessChange(reference, bias))) {}

void Figure6::add(const std::string& name, const IntensityChange& change, const FrameErrors* e) {
  constexpr float kFullColor = 2;  // events
  names_.push_back(name);
  rows_[0].push_back(draw(change.dI, scale_dI_, "relative L1", e ? e->dI_l1 : -1));
  rows_[1].push_back(draw(brightnessChange(change, bias_), scale_dL_, "relative L1", e ? e->dL_l1 : -1));
  rows_[2].push_back(draw(eventBalance(change, bias_, threshold_), kFullColor, "false events",
                          e ? e->rates.false_events : -1));
}

void Figure6::write(Page& page) const {
  page.pictures(names_, {"change of intensity", "change of brightness", "events"}, rows_);
}

}  // namespace saccade
