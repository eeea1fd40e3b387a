#include "eval/figures/odds_bins.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "events/sensor.h"

namespace saccade::eval {
namespace {

void add(const OddsBin& one, OddsBin& mean) {
  if (one.events == 0) return;
  const double events = mean.events + one.events;
  mean.odds += (one.odds - mean.odds) * one.events / events;
  mean.false_share += (one.false_share - mean.false_share) * one.events / events;
  mean.events = events;
}

}  // namespace

OddsBin OddsBins::mean(int first, int last) const {
  OddsBin mean;
  for (int i = first; i < last; ++i) add(bins[i], mean);
  return mean;
}

double OddsBins::error() const {
  double sum = 0;
  for (const OddsBin& bin : bins) sum += bin.events * std::abs(bin.odds - bin.false_share);
  const double events = mean().events;
  return events > 0 ? sum / events : 0;
}

OddsBins binsOfOdds(const ChangeSequence& run, const ChangeSequence& truth, double bias, double C) {
  SACCADE_CHECK(run.size() == truth.size());
  SensorConfig config{.threshold = C, .threshold_off = C, .bias = bias, .reconstruction = "direct"};
  config.labels = true;
  const BrightnessSequence seen = brightnessOf(run, config), ref = brightnessOf(truth, config);
  Sensor sensor(config, seen.L_start.width(), seen.L_start.height());
  SensorOutput out;
  OddsBins result;
  for (std::size_t f = 0; f < run.size(); ++f) {
    sensor.generate(*run[f], out);
    for (const Event& e : out.events) {
      const double share = 1 - ref.dL[f].at(e.x, e.y) / seen.dL[f].at(e.x, e.y), odds = e.artefact / 255.0;
      add({1, odds, std::clamp(share, 0.0, 1.0)},
          result.bins[std::min(kOddsBins - 1, static_cast<int>(odds * kOddsBins))]);
    }
  }
  return result;
}

}  // namespace saccade::eval
