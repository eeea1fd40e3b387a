// A wall whose light goes off, before methods that take both passes.
#pragma once

#include <gtest/gtest.h>

#include <utility>

#include "base/tile_pool.h"
#include "filter/synthetic.h"
#include "methods/method.h"

namespace saccade::test {

inline constexpr int kW = 40, kH = 30;

// A standing wall. From frame `off` on it is dark.
struct SwitchedWall : ::testing::Test {
  SwitchedWall() { makeWall(a), makeWall(b); }
  void run(Method& method, int frames, int off) {
    draw(a, 0, off);
    method.start(a, pool);
    Frame *prev = &a, *cur = &b;
    for (int t = 1; t <= frames; ++t) {
      draw(*cur, t, off);
      method.estimate({*cur, *prev}, pool, change, times);
      std::swap(cur, prev);
    }
  }
  // Pass 1 has the numbers of the frame before.
  void draw(Frame& frame, int t, int off) {
    const float high = t < off ? 1.5f : 0, low = t < off ? 0.5f : 0;
    frame.index = static_cast<FrameIndex>(t);
    fillRandom(frame.samples.I1, static_cast<std::uint64_t>(t), low, high);
    fillRandom(frame.samples.I2, static_cast<std::uint64_t>(t + 1), low, high);
  }
  TilePool pool{1};
  Frame a{kW, kH}, b{kW, kH};
  IntensityChange change{kW, kH};
  StageTimes times;
};

}  // namespace saccade::test
