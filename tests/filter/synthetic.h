// Frames and planes made up by a test: no renderer needed.
#pragma once

#include "base/hash_rng.h"
#include "frame/frame.h"

namespace saccade::test {

// Uniform in [0, 1), addressed like all our random numbers.
inline float randomAt(std::uint64_t seed, int x, int y) {
  return toUnit(hashKey(hashKey(seed, static_cast<std::uint64_t>(x)), static_cast<std::uint64_t>(y)));
}

inline void fillRandom(ImageF& plane, std::uint64_t seed, float low = 0, float high = 1) {
  for (int y = 0; y < plane.height(); ++y) {
    for (int x = 0; x < plane.width(); ++x) plane.at(x, y) = low + (high - low) * randomAt(seed, x, y);
  }
}

inline void fillInside(ImageF& plane, float value) {
  for (int y = 0; y < plane.height(); ++y) {
    for (int x = 0; x < plane.width(); ++x) plane.at(x, y) = value;
  }
}

// A grey wall seen head-on by a standing camera, lit by nothing yet.
inline void makeWall(Frame& frame, float depth = 5) {
  GBuffer& g = frame.g;
  fillInside(g.z, depth);
  fillInside(g.z_in_prev, depth);
  fillInside(g.dz, 0);
  fillInside(g.nz, -1);
  fillInside(g.albedo, 0.5f);
  frame.samples.spp1 = frame.samples.spp2 = 1;
}

}  // namespace saccade::test
