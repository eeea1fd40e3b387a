// Where a surface point was in the previous frame: four bilinear taps, each kept only if the same surface is
// seen there; failing those, the nine pixels around it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/vec.h"
#include "frame/frame.h"

namespace saccade {

// [ours] A tap shows the same surface if its depth is the one our point had in the previous camera, and its
// normal is alike: within 26 degrees. Falcor's factor 10 on the slope is kept, and 2 % of the depth comes on
// top.
class SameSurface {
 public:
  SameSurface(const GBuffer& cur, const GBuffer& prev, int x, int y)
      : prev_(prev),
        n_{cur.nx.at(x, y), cur.ny.at(x, y), cur.nz.at(x, y)},
        z_(cur.z_in_prev.at(x, y)),
        tolerance_(10 * cur.dz.at(x, y) + 0.02f * cur.z.at(x, y)) {}

  // Whether any tap around (px, py) may count. Taps outside the picture meet the border's zero normals.
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

// [Falcor] with its faults: the depth is compared with that of now, so that a fast dolly loses all history;
// its tolerance is in scene units; and column 0 and row 0 never have a history.
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
    const bool seen = dot(n, n) > 0;  // not the border
    return seen & (std::abs(prev_.z.row(0)[tap] - z_) <= depth_tolerance_) &
           (length(n - n_) <= normal_tolerance_);
  }

 private:
  static Vec3 normalAt(const GBuffer& g, int x, int y) {
    return {g.nx.at(x, y), g.ny.at(x, y), g.nz.at(x, y)};
  }
  // Length of the change of the normal to the next pixel, both ways added up.
  static float fwidth(const GBuffer& g, int x, int y) {
    const Vec3 n = normalAt(g, x, y), a = normalAt(g, x + 1, y) - n, b = normalAt(g, x, y + 1) - n;
    return length(
        Vec3{std::abs(a.x) + std::abs(b.x), std::abs(a.y) + std::abs(b.y), std::abs(a.z) + std::abs(b.z)});
  }

  const GBuffer& prev_;
  Vec3 n_;
  float z_, depth_tolerance_, normal_tolerance_;
};

// W of the paper's recursions: how a pixel looks at planes of the previous frame. Offsets count pixels from
// the start of a plane's row 0.
class Reprojection {
 public:
  // For pixel (x, y) of the current frame. `Surface` says which taps show the same surface.
  template <class Surface>
  static Reprojection find(const GBuffer& cur, const GBuffer& prev, int x, int y, const Surface& same) {
    const auto w = static_cast<float>(prev.z.width()), h = static_cast<float>(prev.z.height());
    const float px = std::clamp(static_cast<float>(x) + cur.motion_x.at(x, y), -2.f, w + 1);
    const float py = std::clamp(static_cast<float>(y) + cur.motion_y.at(x, y), -2.f, h + 1);
    const float x0 = std::floor(px), y0 = std::floor(py), fx = px - x0, fy = py - y0;
    Reprojection r;
    if (!same.inside(px, py)) return r;
    const std::ptrdiff_t stride = prev.z.stride();
    r.first_ = static_cast<std::ptrdiff_t>(y0) * stride + static_cast<std::ptrdiff_t>(x0);
    r.addTap(0, r.first_, (1 - fx) * (1 - fy), same);
    r.addTap(1, r.first_ + 1, fx * (1 - fy), same);
    r.addTap(2, r.first_ + stride, (1 - fx) * fy, same);
    r.addTap(3, r.first_ + stride + 1, fx * fy, same);
    if (!r.found()) {
      r.lookAround(r.first_ + (fy >= 0.5f ? stride : 0) + (fx >= 0.5f ? 1 : 0), stride, same);
    } else {
      for (float& weight : r.weight_) weight /= r.sum_;
    }
    return r;
  }

  bool found() const { return sum_ >= kLeastWeight; }
  std::ptrdiff_t strongest() const { return strongest_; }  // the tap that weighs most; of a found one

  // W v: the plane v of the previous frame, seen from here; 0 if nothing was found.
  float operator()(const ImageF& v) const {
    if (!found()) return 0;
    const std::ptrdiff_t stride = v.stride();
    if (around_) return mean(v);
    const float* p = v.row(0) + first_;
    return weight_[0] * p[0] + weight_[1] * p[1] + weight_[2] * p[stride] + weight_[3] * p[stride + 1];
  }

 private:
  static constexpr float kLeastWeight = 0.01f;  // [Falcor] of valid taps together

  template <class Surface>
  void addTap(int i, std::ptrdiff_t tap, float bilinear, const Surface& same) {
    weight_[i] = same(tap) ? bilinear : 0.f;
    if (weight_[i] > heaviest_) heaviest_ = weight_[i], strongest_ = tap;
    sum_ += weight_[i];
  }

  // [Falcor] The plain mean of the valid pixels of the 3x3 around the nearest one.
  template <class Surface>
  void lookAround(std::ptrdiff_t nearest, std::ptrdiff_t stride, const Surface& same) {
    first_ = nearest, around_ = 0, sum_ = 0;
    for (int i = 0; i < 9; ++i) {
      const std::ptrdiff_t tap = nearest + (i / 3 - 1) * stride + (i % 3 - 1);
      if (!same(tap)) continue;
      around_ |= 1u << i, sum_ += 1, strongest_ = tap;
    }
  }

  float mean(const ImageF& v) const {
    float total = 0;
    for (int i = 0; i < 9; ++i) {
      if (around_ >> i & 1) total += v.row(0)[first_ + (i / 3 - 1) * v.stride() + (i % 3 - 1)];
    }
    return total / sum_;
  }

  std::ptrdiff_t first_ = 0, strongest_ = 0;  // upper left tap; of nine, the middle one
  float weight_[4] = {}, sum_ = 0, heaviest_ = 0;
  unsigned around_ = 0;  // which of the nine count; 0: the four bilinear taps
};

}  // namespace saccade
