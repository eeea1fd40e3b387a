// The thresholds C+ and C- of pixels: equal ones, or those of each pixel.
#pragma once

#include <bit>
#include <cstdint>

#include "base/wide.h"
#include "events/sensor_config.h"
#include "frame/image.h"

namespace saccade {

// The largest float below `limit` > 0.
inline float below(double limit) {
  const float f = static_cast<float>(limit);
  return f < limit ? f : std::bit_cast<float>(std::bit_cast<std::uint32_t>(f) - 1);
}

class EqualThresholds {
 public:
  EqualThresholds(const SensorConfig& config, int, int)
      : on_(config.threshold), off_(config.threshold_off), low_(-below(off_)), high_(below(on_)) {}

  double on(int, int) const { return on_; }
  double off(int, int) const { return off_; }
  // The smallest and largest level between the thresholds.
  float lowest(int, int) const { return low_; }
  float highest(int, int) const { return high_; }
  // For eight pixels from (x, y) on, x a multiple of 8: levels strictly between these are between the
  // thresholds.
  float lowBounds(int, int) const { return low_; }
  float highBounds(int, int) const { return high_; }

 private:
  double on_, off_;
  float low_, high_;
};

// With mismatch [noise/README]: C+ and C- of each pixel are Gaussian, with the configured ones as means.
class OwnThresholds {
 public:
  OwnThresholds(const SensorConfig& config, int width, int height);

  double on(int x, int y) const { return on_.at(x, y); }
  double off(int x, int y) const { return off_.at(x, y); }
  float lowest(int x, int y) const { return -below(off_.at(x, y)); }
  float highest(int x, int y) const { return below(on_.at(x, y)); }
  Floats<8> lowBounds(int x, int y) const { return -load<8>(off_.row(y) + x); }
  Floats<8> highBounds(int x, int y) const { return load<8>(on_.row(y) + x); }

 private:
  ImageF on_, off_;
};

}  // namespace saccade
