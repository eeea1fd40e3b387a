// Pieces of log brightness: it is straight in time from one update of a pixel to the next.
#pragma once

#include <array>
#include <cstdint>

namespace saccade {

// Some pieces of single pixels, field by field. Those of one pixel are in order of time.
struct Pieces {
  static constexpr int kMost = 256;

  int count = 0;  // at most kMost
  std::array<std::uint16_t, kMost> x, y;
  std::array<float, kMost> from, to;  // shares of the interval, 0 <= from < to <= 1
  std::array<float, kMost> dL;        // change of log brightness, finite
  std::array<float, kMost> I;         // intensity at `to`
};

}  // namespace saccade
