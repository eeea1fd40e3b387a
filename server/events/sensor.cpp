#include "events/sensor.h"

#include "base/check.h"
#include "events/artefact_odds.h"
#include "events/log_ratio.h"
#include "events/log_response.h"

namespace saccade {

Sensor::Sensor(const SensorConfig& config, int width, int height)
    : bias_(static_cast<float>(config.bias)),
      judges_(config.labels || config.max_artefact_odds < 1),
      max_artefact_odds_(config.max_artefact_odds),
      dL_(width, height) {
  SACCADE_CHECK(!findFault(config));
  SACCADE_CHECK(width <= UINT16_MAX && height <= UINT16_MAX);
  reconstruction_ = findReconstruction(config.reconstruction)->make(config, width, height);
  model_ = findEventModel(config.model)->make(config, width, height);
}

PixelState Sensor::pixelsAtStart(const ImageF& I_prev) const {
  PixelState pixels;
  for (int y = 0; y < I_prev.height(); ++y) {
    for (int x = 0; x < I_prev.width(); ++x) {
      const float L = finiteLogBrightness(I_prev.at(x, y), bias_);
      pixels.brightness.push_back(L);
      pixels.reference.push_back(L - model_->level(x, y));
    }
  }
  return pixels;
}

void Sensor::generate(const IntensityChange& change, SensorOutput& out) {
  const Interval interval{change.t0, change.t1, change.frame};
  logResponse(change, bias_, dL_);
  reconstruction_->reconstruct(change, dL_);
  out.events.clear();
  out.suppressed = model_->generate(dL_, interval, out.events);
  out.artefacts = 0;
  if (judges_) judge(change, out);
  order_.sort(out.events, interval);
  giveBackSlack(out.events);
}

void Sensor::judge(const IntensityChange& change, SensorOutput& out) {
  labelArtefacts(change, bias_, dL_, out.events);
  out.artefacts = removeArtefacts(max_artefact_odds_, out.events);
  out.suppressed += out.artefacts;
}

}  // namespace saccade
