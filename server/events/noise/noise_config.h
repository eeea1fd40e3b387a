// How much noise a sensor has, in physical units.
#pragma once

#include <span>

#include "saccade/wire/ranges.h"

namespace saccade {

// Field by field as message Noise; ranges in wire/ranges.h. A part is off where its amount is 0.
struct NoiseConfig {
  // Parts of the pixel shape the signal.
  double mismatch = 0;             // standard deviation of C+ and C- over the pixels, fraction of C
  double photoreceptor_hz = 0;     // bandwidth at the reference luminance
  double follower_hz = 0;          // bandwidth of the pole behind it
  double asymmetry = 0;            // of rises and falls in the photoreceptor: 0 none, 1 that of the circuit
  double reference_luminance = 1;  // scene luminance
  double dark_luminance = 0;       // dark current, added to the luminance of the scene
  double level_leak_hz = 0;        // ON events per pixel, by a steady rise of its level
  double brownian_hz = 0;          // events per pixel of the model stochastic, at the reference luminance
  // Noise events are beside the signal.
  double leak_hz = 0;      // per pixel
  double shot_hz = 0;      // per pixel in the dark
  double rate_spread = 0;  // over the pixels, of the rates of leak and shot noise: deviation of ln(rate)
  double hot_fraction = 0;
  double hot_hz = 100;  // per hot pixel
  // The readout takes both.
  double dead_fraction = 0;
  double jitter_s = 0;
  double readout_hz = 0;         // events per second of the whole sensor
  double readout_buffer = 1024;  // events that can wait for it

  bool operator==(const NoiseConfig&) const = default;
};

struct NoiseField {
  const char* name;  // as the schema names it
  double NoiseConfig::*value;
  Range<double> range;
};

// All fields.
std::span<const NoiseField> noiseFields();

// The name of the first amount that belongs to the pixels, and that differs; nullptr: none. Changes of a
// sensor keep these amounts: mismatch, rate_spread, brownian_hz.
const char* changedPixelAmount(const NoiseConfig& before, const NoiseConfig& after);

// The variance of the Brownian motion in the dark, over that at the reference luminance.
inline constexpr double kMostBrownian = 10;

// The noise events of a dark pixel, on average over the pixels: Hz.
double noiseRate(const NoiseConfig& noise);

}  // namespace saccade
