// The expected behaviour of a sensor, in closed form.
#pragma once

#include "eval/sensor/noise_rate.h"
#include "events/sensor_config.h"

namespace saccade::eval {

// The change of log(I_eps + I_dark + I) [E (1)] where log intensity changes by `change` from that of `I`.
double brightnessChange(const SensorConfig& config, double I, double change);

// The share of the pixels that answer a step of log intensity. Levels are uniform over C+ + C-, so it is |dL|
// / (C+ + C-), at most 1. [ours] Without mismatch and low pass.
double expectedAnswers(const SensorConfig& config, double I, double step);

// The share of the pixels whose threshold is within `change`: the normal distribution of the mismatch.
double expectedWithin(const SensorConfig& config, double I, double change);

// Leak, hot pixels, shot noise and the motion of the level on a still picture.
NoiseRate expectedNoise(const SensorConfig& config, double I);

// Seconds by which the photoreceptor's output lags behind a slow change at `I`.
double lagOf(const NoiseConfig& noise, double I);

// The gain of a small sinusoid: that of the bias, and of the poles at `I`.
double expectedGain(const SensorConfig& config, double I, double hz);

// A quantile of the latencies of the pixels that answer a step, in seconds. A pixel waits until the step
// response of the poles reaches a part of dL. That part is uniform in (0, C+ + C-) over the pixels. [ours]
// Without mismatch, jitter, and an asymmetry before a follower.
double expectedLatency(const SensorConfig& config, double I, double step, double quantile);

}  // namespace saccade::eval
