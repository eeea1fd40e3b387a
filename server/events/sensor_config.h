// What a client chooses about its sensor.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "base/units.h"

namespace saccade {

struct SensorConfig {
  double threshold = 0.2;                 // C+, natural log units, [1e-3, 10]; ON events
  double threshold_off = 0.2;             // C-, as C+; OFF events
  double bias = 1e-3;                     // I_eps, scene luminance, [1e-12, 1e6] [E (1)]
  std::string model = "accumulating";     // a name of eventModelTable()
  std::string reconstruction = "kalman";  // a name of reconstructionTable()
  // Of complementary: below it the primal is believed, above it the difference; Hz, [1e-4, 1e4]. At 0.5 Hz a
  // drift is drawn back within 0.3 s, 160 frames at 500 Hz: long enough to average over a primal that
  // remembers 19.
  double reconstruction_cutoff_hz = 0.5;
  TimeNs refractory{0};  // [0, 10 s]; blind so long after an event, then starts from the level it sees
  int max_events_per_pixel_frame = 32;  // [1, 65536]; what exceeds it is suppressed and counted
  // Of all pixels together, >= 1. Beyond it the pixels that come later, row by row, are suppressed and
  // counted.
  std::uint64_t max_events_per_frame = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t seed = 0;  // start phase of every pixel; random numbers of the model
};

// What is wrong with a configuration: the first offending field, named as in the schema, and what is valid.
struct SensorFault {
  std::string field, message;
};
std::optional<SensorFault> findFault(const SensorConfig& config);

}  // namespace saccade
