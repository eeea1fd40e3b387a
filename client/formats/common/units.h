// Units of time.
#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>

namespace saccade::client {

inline constexpr std::int64_t kNsPerUs = 1000, kNsPerSecond = 1'000'000'000;

inline double secondsOf(std::int64_t ns) {
  return static_cast<double>(ns) / kNsPerSecond;
}

inline std::chrono::milliseconds millisecondsOf(double seconds) {
  return std::chrono::milliseconds(std::llround(seconds * 1e3));
}

}  // namespace saccade::client
