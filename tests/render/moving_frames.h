// Frames of scenes that move.
#pragma once

#include <cmath>

#include "render/renderer.h"

namespace saccade::test {

inline constexpr int kSize = 32;  // of both sides, pixels

inline Frame render(const PosedScene& now, const PosedScene& before) {
  TilePool pool(2);
  Frame frame(kSize, kSize);
  const Camera camera(now.still().description().T_world_camera, pinhole(80, kSize, kSize));
  Renderer renderer({2, 1});
  renderer.render(PixelContext({now, camera}, {before, camera}), SeedPlan::correlated(1, 1, 64), pool, frame);
  return frame;
}

inline double meanDifference(const ImageF& a, const ImageF& b) {
  double sum = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) sum += std::abs(a.at(x, y) - b.at(x, y));
  return sum / (kSize * kSize);
}

}  // namespace saccade::test
