// The unit of each amount of noise, and how v2e counts where it differs, for the help of the options.
#pragma once

#include <string>

namespace saccade {

struct NoiseUnit {
  const char *name, *unit;
};

// The fields of message Noise, in groups: the pixel, noise events, the readout.
inline constexpr NoiseUnit kNoiseUnits[] = {
    {"mismatch", "fraction of C; v2e's sigma_thres is C times this"},
    {"photoreceptor_hz", "Hz, of a surface of reference_luminance, which is 255 in v2e"},
    {"follower_hz", "Hz"},
    {"asymmetry", "0 to 1; v2e has 0"},
    {"reference_luminance", "scene luminance"},
    {"dark_luminance", "scene luminance; v2e has 0"},
    {"level_leak_hz", "Hz per pixel, and moves the level as v2e's leak_rate_hz does"},
    {"brownian_hz", "Hz per pixel, at reference_luminance; only of the model stochastic"},
    {"leak_hz", "Hz per pixel, beside the signal"},
    {"shot_hz", "Hz per pixel in the dark, as in v2e"},
    {"rate_spread", "deviation of ln(rate); v2e's noise_rate_cov_decades is 0.434 times this"},
    {"hot_fraction", "share of the pixels"},
    {"hot_hz", "Hz per hot pixel"},
    {"dead_fraction", "share of the pixels"},
    {"jitter_s", "seconds"},
    {"readout_hz", "events per second of the whole sensor"},
    {"readout_buffer", "events"},
};

// "mismatch (fraction of C; ...), photoreceptor_hz (Hz, ...), ..."
inline std::string noiseUnitTexts() {
  std::string text;
  for (const NoiseUnit& row : kNoiseUnits)
    text += std::string(text.empty() ? "" : ", ") + row.name + " (" + row.unit + ")";
  return text;
}

}  // namespace saccade
