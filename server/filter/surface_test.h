// Tests whether a pixel of the previous frame shows the same surface as a pixel of this one.
#pragma once

#include <cmath>
#include <cstddef>

#include "base/vec.h"
#include "frame/frame.h"

namespace saccade {

// [ours] Compares a tap's depth with the depth of the point in the previous camera, and the normals: they may
// differ by 26 degrees. The tolerance is Falcor's, 10 times the slope, plus 2 % of the depth.
class SameSurface {
 public:
  SameSurface(const GBuffer& cur, const GBuffer& prev, int x, int y)
      : prev_(prev),
        n_{cur.nx.at(x, y), cur.ny.at(x, y), cur.nz.at(x, y)},
        z_(cur.z_in_prev.at(x, y)),
        tolerance_(10 * cur.dz.at(x, y) + 0.02f * cur.z.at(x, y)) {}

  // Whether taps around (px, py) can be valid. Taps outside the picture meet the border's zero normals.
  static constexpr bool inside(float, float) { return true; }

  bool operator()(std::ptrdiff_t tap) const {
    const bool depth = std::abs(prev_.z.row(0)[tap] - z_) <= tolerance_;
    const Vec3 n{prev_.nx.row(0)[tap], prev_.ny.row(0)[tap], prev_.nz.row(0)[tap]};
    return depth & (dot(n_, n) >= 0.9f);
  }

 private:
  const GBuffer& prev_;
  Vec3 n_;
  float z_, tolerance_;
};

// [Falcor] with its faults. It compares with the current depth, so that a fast dolly loses all history. Its
// tolerance is in scene units. Column 0 and row 0 never have a history.
class FalcorSurface {
 public:
  FalcorSurface(const GBuffer& cur, const GBuffer& prev, int x, int y)
      : prev_(prev),
        n_(normalAt(cur, x, y)),
        z_(cur.z.at(x, y)),
        depth_tolerance_(10 * (cur.dz.at(x, y) + 0.01f)),
        normal_tolerance_(16 * (fwidth(cur, x, y) + 0.01f)) {}

  bool inside(float px, float py) const {
    const float x = std::round(px), y = std::round(py);
    return x >= 1 && y >= 1 && x <= static_cast<float>(prev_.z.width() - 1) &&
           y <= static_cast<float>(prev_.z.height() - 1);
  }

  bool operator()(std::ptrdiff_t tap) const {
    const Vec3 n{prev_.nx.row(0)[tap], prev_.ny.row(0)[tap], prev_.nz.row(0)[tap]};
    const bool seen = dot(n, n) > 0;  // false in the border
    return seen & (std::abs(prev_.z.row(0)[tap] - z_) <= depth_tolerance_) &
           (length(n - n_) <= normal_tolerance_);
  }

 private:
  static Vec3 normalAt(const GBuffer& g, int x, int y) {
    return {g.nx.at(x, y), g.ny.at(x, y), g.nz.at(x, y)};
  }
  // Length of the normal's change to the next pixel, summed over both axes.
  static float fwidth(const GBuffer& g, int x, int y) {
    const Vec3 n = normalAt(g, x, y), a = normalAt(g, x + 1, y) - n, b = normalAt(g, x, y + 1) - n;
    return length(
        Vec3{std::abs(a.x) + std::abs(b.x), std::abs(a.y) + std::abs(b.y), std::abs(a.z) + std::abs(b.z)});
  }

  const GBuffer& prev_;
  Vec3 n_;
  float z_, depth_tolerance_, normal_tolerance_;
};

}  // namespace saccade
