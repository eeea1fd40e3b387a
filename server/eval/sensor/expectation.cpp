#include "eval/sensor/expectation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace saccade::eval {
namespace {

// The formulas of events/noise. I / R, at most 1.
double relativeLuminance(const NoiseConfig& noise, double I) {
  return std::min(1.0, I / noise.reference_luminance);
}

// Of the photoreceptor, Hz.
double bandwidth(const NoiseConfig& noise, double I) {
  constexpr double kDark = 0.1;
  return noise.photoreceptor_hz * (relativeLuminance(noise, I) + kDark) / (1 + kDark);
}

double powerOfPole(double hz, double pole_hz) {
  return pole_hz > 0 ? 1 / (1 + (hz / pole_hz) * (hz / pole_hz)) : 1;
}

// The part of a step that two poles have not yet passed after `t`; one pole where the second is 0.
double restOfStep(double t, double hz1, double hz2) {
  const double a = 2 * std::numbers::pi * hz1, b = 2 * std::numbers::pi * hz2;
  if (b == 0) return std::exp(-a * t);
  if (a == b) return (1 + a * t) * std::exp(-a * t);
  return (b * std::exp(-a * t) - a * std::exp(-b * t)) / (b - a);
}

// The time after which this part of a step has not yet passed; `rest` in (0, 1).
double timeOfRest(double rest, double hz1, double hz2) {
  double low = 0, high = 1 / hz1;
  while (restOfStep(high, hz1, hz2) > rest) high *= 2;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (restOfStep(middle, hz1, hz2) > rest ? low : high) = middle;
  }
  return low;
}

}  // namespace

double brightnessChange(const SensorConfig& config, double I, double change) {
  return std::log1p(I * std::expm1(change) / (config.bias + I));
}

double expectedAnswers(const SensorConfig& config, double I, double step) {
  const double dL = std::abs(brightnessChange(config, I, step));
  return (1 - config.noise.dead_fraction) * std::min(1.0, dL / (config.threshold + config.threshold_off));
}

double expectedWithin(const SensorConfig& config, double I, double change) {
  const double C = change > 0 ? config.threshold : config.threshold_off;
  const double over = std::abs(brightnessChange(config, I, change)) - C, sigma = config.noise.mismatch * C;
  const double share = sigma > 0 ? std::erfc(-over / sigma / std::numbers::sqrt2) / 2 : over >= 0;
  return (1 - config.noise.dead_fraction) * share;
}

NoiseRate expectedNoise(const SensorConfig& config, double I) {
  const NoiseConfig& noise = config.noise;
  const double alive = 1 - noise.dead_fraction;
  const double shot = noise.shot_hz * (1 - 0.75 * relativeLuminance(noise, I));
  return {alive * (noise.leak_hz + noise.hot_fraction * noise.hot_hz + shot / 2), alive * shot / 2};
}

double lagOf(const NoiseConfig& noise, double I) {
  return noise.photoreceptor_hz > 0 ? 1 / (2 * std::numbers::pi * bandwidth(noise, I)) : 0;
}

double expectedGain(const SensorConfig& config, double I, double hz) {
  const NoiseConfig& noise = config.noise;
  return I / (config.bias + I) *
         std::sqrt(powerOfPole(hz, bandwidth(noise, I)) * powerOfPole(hz, noise.follower_hz));
}

double expectedLatency(const SensorConfig& config, double I, double step, double quantile) {
  if (config.noise.photoreceptor_hz == 0) return 0;
  const double dL = std::abs(brightnessChange(config, I, step));
  const double wait = quantile * std::min(1.0, (config.threshold + config.threshold_off) / dL);
  return timeOfRest(1 - wait, bandwidth(config.noise, I * std::exp(step)), config.noise.follower_hz);
}

}  // namespace saccade::eval
