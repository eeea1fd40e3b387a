// The state of the grid at several points, a point in each lane.
#pragma once

#include "cache/grid/level_blend.h"

namespace saccade {

inline constexpr int kPointLanes = 8;
using PointFloats = Floats<kPointLanes>;

// Memory that lanes are gathered into, one value after another.
template <std::size_t kValues>
struct alignas(64) LaneMemory {
  float values[kValues][kPointLanes] = {};

  template <class V>
  void set(int lane, const V& v) {
    for (std::size_t i = 0; i < kValues; ++i) values[i][lane] = v[static_cast<int>(i)];
  }
  template <class V>
  V at(int lane) const {
    V v{};
    for (std::size_t i = 0; i < kValues; ++i) v[static_cast<int>(i)] = values[i][lane];
    return v;
  }
  std::array<PointFloats, kValues> lanes() const {
    std::array<PointFloats, kValues> all;
    for (std::size_t i = 0; i < kValues; ++i) all[i] = load<kPointLanes>(values[i]);
    return all;
  }
};

// A few points of one row, at most kPointLanes.
struct PointLanes {
  int count = 0;
  std::array<std::size_t, kPointLanes> points;  // of Placement::points
  std::array<LaneMemory<4>, kGridLevels> light;
  std::array<LaneMemory<8>, kTop> evidence;
  LaneMemory<1> fraction;

  bool full() const { return count == kPointLanes; }
  void add(const GridLevels& levels, const Placement& at, std::size_t point) {
    const GridPoint& p = at.points[point];
    for (int k = 0; k < kGridLevels; ++k) light[k].set(count, gather(levels[p.level + k].light, at, p, k));
    for (int k = 0; k < kTop; ++k)
      evidence[k].set(count, gather(levels[p.level + k + kPoolSteps].evidence, at, p, k + kPoolSteps));
    fraction.values[0][count] = p.fraction;
    points[count++] = point;
  }
  LevelBlend<PointFloats> blend(const BlendParams& params) const {
    return {[this](int k) { return light[k].lanes(); },
            [this](int slot) { return evidence[slot - kPoolSteps].lanes(); }, fraction.lanes()[0], params};
  }
};

}  // namespace saccade
