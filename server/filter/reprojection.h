// Finds a surface point in the previous frame. Takes those of four bilinear taps that show the same surface,
// or else those of the nine pixels around it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "frame/frame.h"

namespace saccade {

// W of the paper's recursions: reads a plane of the previous frame at the place where a pixel's surface was.
// Offsets count pixels from the start of a plane's row 0.
class Reprojection {
 public:
  // For pixel (x, y) of the current frame. `same` says which taps show its surface, see surface_test.h.
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
  std::ptrdiff_t strongest() const { return strongest_; }  // the tap of the largest weight; needs found()

  // W v, for the plane v of the previous frame; 0 unless found().
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
  unsigned around_ = 0;  // bits of the valid ones of nine; 0: the four bilinear taps
};

}  // namespace saccade
