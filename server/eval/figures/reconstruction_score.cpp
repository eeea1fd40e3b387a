#include "eval/figures/reconstruction_score.h"

#include <cmath>

#include "base/quantile.h"
#include "eval/figures/spectrum.h"
#include "eval/metrics/event_rates.h"
#include "eval/metrics/event_streams.h"
#include "eval/metrics/for_each_pixel.h"

namespace saccade::eval {
namespace {

// Events of each frame at the phases they share.
void scoreRates(const BrightnessSequence& L, const BrightnessSequence& truth, double C,
                ReconstructionScore& score) {
  const double frames = static_cast<double>(L.dL.size());
  for (std::size_t f = 0; f < L.dL.size(); ++f) {
    const EventRates rates = integratedRates(L.dL[f], truth.dL[f], C);
    score.false_events += rates.false_events / frames;
    score.missed_events += rates.missed_events / frames;
  }
}

// Drift and noise, pixel by pixel.
void scoreErrors(const BrightnessSequence& L, const BrightnessSequence& truth, double rate_hz,
                 ReconstructionScore& score) {
  std::vector<double> drift, offset;
  double power = 0;
  forEachPixel(L.L_start, [&](int x, int y) {
    std::vector<double> error;
    for (std::size_t f = 0; f < L.dL.size(); ++f)
      error.push_back(static_cast<double>(L.dL[f].at(x, y)) - truth.dL[f].at(x, y));
    power += powerSpectrum(error, rate_hz).powerAbove(rate_hz / 4);
    const double start = static_cast<double>(L.L_start.at(x, y)) - truth.L_start.at(x, y);
    double sum = 0;
    for (const double e : error) sum += e;
    drift.push_back(std::abs(sum));
    offset.push_back(std::abs(start + sum));
  });
  score.high_rms = std::sqrt(power / static_cast<double>(drift.size()));
  score.drift = quantile(drift, 0.5), score.offset = quantile(offset, 0.5);
}

}  // namespace

ReconstructionScore scoreReconstruction(const ChangeSequence& run, const ChangeSequence& truth,
                                        const SensorConfig& config) {
  SACCADE_CHECK(run.size() == truth.size());
  SensorConfig plain = config;
  plain.reconstruction = "direct";
  const BrightnessSequence L = brightnessOf(run, config), L_truth = brightnessOf(truth, plain);
  ReconstructionScore score;
  scoreRates(L, L_truth, config.threshold, score);
  scoreErrors(L, L_truth, 1 / seconds(run.front()->t1 - run.front()->t0), score);
  const Events events = eventsOf(run, config), expected = eventsOf(truth, plain);
  score.count_error = countError(events, expected);
  score.voxel_error = voxelError(events, expected);
  return score;
}

}  // namespace saccade::eval
