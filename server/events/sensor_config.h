// The settings of a sensor, and their check.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "base/units.h"
#include "events/noise/noise_config.h"

namespace saccade {

// Ranges: wire/ranges.h.
struct SensorConfig {
  double threshold = 0.2;              // C+ of ON events, natural log units
  double threshold_off = 0.2;          // C- of OFF events, as C+
  double bias = 1e-3;                  // I_eps, scene luminance [E (1)]
  std::string model = "accumulating";  // a name of eventModelTable()
  // Whether a pixel starts at a random level between its thresholds; else at that of the first frame, v = 0.
  bool random_start = true;
  std::string reconstruction = "kalman";  // a name of reconstructionTable()
  // Hz, of complementary: the sensor follows the primal below it and the difference above it. At 0.5 Hz a
  // drift decays within 0.3 s, which is 160 frames at 500 Hz. That is long enough to average over a primal
  // that remembers 19.
  double reconstruction_cutoff_hz = 0.5;
  TimeNs refractory{0};  // a pixel is blind so long after an event, then starts from the level it sees
  int max_events_per_pixel_frame = 32;  // further events are suppressed and counted
  // Of all pixels together, >= 1. Further events, row by row from the top, are suppressed and counted.
  std::uint64_t max_events_per_frame = std::numeric_limits<std::uint64_t>::max();
  bool labels = false;           // whether events tell their odds to be an artefact
  double max_artefact_odds = 1;  // events with higher odds are suppressed and counted
  std::uint64_t seed = 0;        // start phase of every pixel; random numbers of model and noise
  NoiseConfig noise{};           // off by default
};

// New settings from the first interval that begins at `time` or later.
struct SensorChange {
  TimeNs time{0};
  std::optional<double> threshold = {}, threshold_off = {},
                        bias = {};        // as in SensorConfig; unset: as before
  std::optional<NoiseConfig> noise = {};  // all of it, with the mismatch of before
};
SensorConfig changed(SensorConfig config, const SensorChange& change);
// Both at once: what `last` leaves unset stays as in `first`.
SensorChange together(SensorChange first, const SensorChange& last);

struct SensorFault {
  std::string field, message;  // the field as the schema names it
};
// The first fault of a configuration, or nothing.
std::optional<SensorFault> findFault(const SensorConfig& config);

}  // namespace saccade
