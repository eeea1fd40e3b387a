// Frames of change with known values.
#pragma once

#include <cmath>
#include <vector>

#include "frame/intensity_change.h"

namespace saccade::test {

inline constexpr double kFrameRateHz = 250;

// The frames 1, 2 and so on. Every pixel has I_prev = 1 and changes by dL(frame, x, y) under a bias of
// `bias`. The primal stays 1.
template <class Change>
std::vector<IntensityChange> frames(int count, int width, int height, double bias, Change dL) {
  std::vector<IntensityChange> changes;
  for (int f = 1; f <= count; ++f) {
    IntensityChange& c = changes.emplace_back(width, height);
    c.frame = static_cast<FrameIndex>(f);
    c.t0 = frameTime(c.frame - 1, kFrameRateHz), c.t1 = frameTime(c.frame, kFrameRateHz);
    c.I_prev.fill(1), c.I_now.fill(1);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x)
        c.dI.at(x, y) = static_cast<float>((1 + bias) * std::expm1(dL(f, x, y)));
    }
  }
  return changes;
}

inline std::vector<const IntensityChange*> sequence(const std::vector<IntensityChange>& changes) {
  std::vector<const IntensityChange*> pointers;
  for (const IntensityChange& c : changes) pointers.push_back(&c);
  return pointers;
}

}  // namespace saccade::test
