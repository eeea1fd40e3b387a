#include "eval/figures/odds_bins.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "events/sensor.h"

namespace saccade::eval {
namespace {

void add(const OddsBin& one, OddsBin& mean) {
  const double events = mean.events + one.events;
  mean.odds += (one.odds - mean.odds) * one.events / events;
  mean.false_share += (one.false_share - mean.false_share) * one.events / events;
  mean.events = events;
}

}  // namespace

double OddsBins::error() const {
  double sum = 0;
  for (const OddsBin& bin : bins) sum += bin.events * std::abs(bin.odds - bin.false_share);
  return all.events > 0 ? sum / all.events : 0;
}

OddsBins binsOfOdds(const ChangeSequence& run, const ChangeSequence& truth, const SensorConfig& config) {
  SACCADE_CHECK(run.size() == truth.size() && config.labels && config.reconstruction == "direct");
  const BrightnessSequence seen = brightnessOf(run, config), ref = brightnessOf(truth, config);
  Sensor sensor(config, seen.L_start.width(), seen.L_start.height());
  SensorOutput out;
  OddsBins result;
  for (std::size_t f = 0; f < run.size(); ++f) {
    sensor.generate(*run[f], out);
    for (const Event& e : out.events) {
      const double share = 1 - ref.dL[f].at(e.x, e.y) / seen.dL[f].at(e.x, e.y), odds = e.artefact / 255.0;
      const OddsBin one{1, odds, std::clamp(share, 0.0, 1.0)};
      add(one, result.bins[std::min(kOddsBins - 1, static_cast<int>(odds * kOddsBins))]);
      add(one, result.all);
    }
  }
  return result;
}

}  // namespace saccade::eval
