// Light of several lanes: a vector of lanes for each channel.
#pragma once

#include <array>

#include "base/vec.h"
#include "render/surface/color.h"

namespace saccade {

template <class F, std::size_t C>
[[gnu::always_inline]] inline F luminanceOf(const std::array<F, C>& c) {
  if constexpr (C == 1) return c[0];
  if constexpr (C == 3) return luminance(Vec3T<F>{c[0], c[1], c[2]});
}

template <class F>
[[gnu::always_inline]] inline void setLane(std::array<F, 1>& lanes, int lane, Color<1> c) {
  lanes[0][lane] = c.y;
}
template <class F>
[[gnu::always_inline]] inline void setLane(std::array<F, 3>& lanes, int lane, Color<3> c) {
  lanes[0][lane] = c.c.x, lanes[1][lane] = c.c.y, lanes[2][lane] = c.c.z;
}
template <class F>
[[gnu::always_inline]] inline Color<1> colorOf(const std::array<F, 1>& lanes, int lane) {
  return Color<1>(lanes[0][lane]);
}
template <class F>
[[gnu::always_inline]] inline Color<3> colorOf(const std::array<F, 3>& lanes, int lane) {
  return Color<3>(Rgb{lanes[0][lane], lanes[1][lane], lanes[2][lane]});
}
}  // namespace saccade
