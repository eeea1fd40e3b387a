// Vectors of several lanes, and the memory that they are loaded from and stored to.
#pragma once

#include "base/vec.h"
#include "base/wide.h"

namespace saccade {

template <class F>
[[gnu::always_inline]] inline Vec3T<F> selectLanes(const auto& condition, const Vec3T<F>& a,
                                                   const Vec3T<F>& b) {
  return {select(condition, a.x, b.x), select(condition, a.y, b.y), select(condition, a.z, b.z)};
}

inline constexpr int kLaneVectors = 16;

struct alignas(64) LaneVectors {
  float x[kLaneVectors], y[kLaneVectors], z[kLaneVectors];

  Vec3 at(int lane) const { return {x[lane], y[lane], z[lane]}; }
  void set(int lane, Vec3 v) { x[lane] = v.x, y[lane] = v.y, z[lane] = v.z; }
  template <int W>
  [[gnu::always_inline]] Vec3T<Floats<W>> lanes(int first) const {
    return {load<W>(&x[first]), load<W>(&y[first]), load<W>(&z[first])};
  }
  template <class F>
  [[gnu::always_inline]] void store(const Vec3T<F>& v, int first) {
    saccade::store(v.x, &x[first]), saccade::store(v.y, &y[first]), saccade::store(v.z, &z[first]);
  }
};

template <class F>
[[gnu::always_inline]] inline void setLane(Vec3T<F>& lanes, int lane, Vec3 v) {
  lanes.x[lane] = v.x, lanes.y[lane] = v.y, lanes.z[lane] = v.z;
}
template <class F>
[[gnu::always_inline]] inline Vec3 laneOf(const Vec3T<F>& lanes, int lane) {
  return {lanes.x[lane], lanes.y[lane], lanes.z[lane]};
}

}  // namespace saccade
