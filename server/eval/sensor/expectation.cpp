#include "eval/sensor/expectation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace saccade::eval {
namespace {

// The formulas of events/noise. I / R, at most 1.
double relativeLuminance(const NoiseConfig& noise, double I) {
  return std::min(1.0, (I + noise.dark_luminance) / noise.reference_luminance);
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

// Added to the intensity before the logarithm: I_eps and the dark current.
double addedTo(const SensorConfig& config) {
  return config.bias + config.noise.dark_luminance;
}

// Events of a level between -C- and C+, with this drift and variance per second. [optional stopping of a
// Brownian motion with drift]
struct Passages {
  double hz, on_share;
};
Passages passagesOf(double drift, double variance, double on, double off, double refractory_s) {
  if (variance == 0 && drift == 0) return {0, 0};
  double on_share = variance == 0, time = on / drift;
  if (variance > 0) {
    const double exponent = 2 * drift / variance;
    on_share =
        exponent == 0 ? off / (on + off) : std::expm1(-exponent * off) / std::expm1(-exponent * (on + off));
    time = exponent == 0 ? on * off / variance : (on * on_share - off * (1 - on_share)) / drift;
  }
  return {1 / (time + refractory_s), on_share};
}

// Events of a pixel whose level moves by leak and Brownian motion, on a still picture.
Passages levelNoise(const SensorConfig& config, double I) {
  const NoiseConfig& noise = config.noise;
  const double light = std::max((I + noise.dark_luminance) / noise.reference_luminance, 1 / kMostBrownian);
  return passagesOf(noise.level_leak_hz * config.threshold,
                    noise.brownian_hz * config.threshold * config.threshold_off / light, config.threshold,
                    config.threshold_off, seconds(config.refractory));
}

}  // namespace

double brightnessChange(const SensorConfig& config, double I, double change) {
  return std::log1p(I * std::expm1(change) / (addedTo(config) + I));
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
  const Passages level = levelNoise(config, I);
  const double on = noise.leak_hz + noise.hot_fraction * noise.hot_hz + shot / 2 + level.hz * level.on_share;
  return {alive * on, alive * (shot / 2 + level.hz * (1 - level.on_share))};
}

double lagOf(const NoiseConfig& noise, double I) {
  return noise.photoreceptor_hz > 0 ? 1 / (2 * std::numbers::pi * bandwidth(noise, I)) : 0;
}

double expectedGain(const SensorConfig& config, double I, double hz) {
  const NoiseConfig& noise = config.noise;
  return I / (addedTo(config) + I) *
         std::sqrt(powerOfPole(hz, bandwidth(noise, I)) * powerOfPole(hz, noise.follower_hz));
}

double expectedLatency(const SensorConfig& config, double I, double step, double quantile) {
  if (config.noise.photoreceptor_hz == 0) return 0;
  const double dL = brightnessChange(config, I, step), s = config.noise.asymmetry;
  const double wait = quantile * std::min(1.0, (config.threshold + config.threshold_off) / std::abs(dL));
  const double hz = bandwidth(config.noise, I * std::exp(step));
  if (s > 0 && config.noise.follower_hz == 0)
    return std::log(std::expm1(s * dL) / std::expm1(s * dL * (1 - wait))) / (2 * std::numbers::pi * hz);
  return timeOfRest(1 - wait, hz, config.noise.follower_hz);
}

}  // namespace saccade::eval
