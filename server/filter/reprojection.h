// Where a surface point was in the previous frame: four bilinear taps, each kept only if the same surface is
// seen there.
#pragma once

#include <algorithm>
#include <cmath>

#include "frame/frame.h"

namespace saccade {

// A set of taps, counted as pixels from the start of a plane's row 0. Weights of taps that are not valid are
// 0.
struct Reprojection {
  std::ptrdiff_t first;      // offset of the upper left tap
  std::ptrdiff_t strongest;  // offset of the tap that weighs most
  float w00, w10, w01, w11;  // add up to 1 if found
  bool found;

  // W v: the picture `v` of the previous frame, seen from here.
  float operator()(const float* v, std::ptrdiff_t stride) const {
    const float* p = v + first;
    return w00 * p[0] + w10 * p[1] + w01 * p[stride] + w11 * p[stride + 1];
  }
};

// [ours] A tap shows the same surface if its depth is the one our point had in the previous camera, and its
// normal is alike. Falcor compares with the depth of now, which loses all history in a fast dolly, and its
// tolerances are in scene units; its factor 10 on the slope is kept.
inline constexpr float kDepthSlopes = 10, kDepthShare = 0.02f, kNormalAgreement = 0.9f;
inline constexpr float kLeastWeight = 0.01f;  // [Falcor] of valid taps together

// For pixel (x, y) of the current frame. Taps outside the picture meet the border's zero normals.
inline Reprojection reproject(const GBuffer& cur, const GBuffer& prev, int x, int y) {
  const std::ptrdiff_t stride = prev.z.stride();
  const auto w = static_cast<float>(prev.z.width()), h = static_cast<float>(prev.z.height());
  const float px = std::clamp(static_cast<float>(x) + cur.motion_x.at(x, y), -2.f, w + 1);
  const float py = std::clamp(static_cast<float>(y) + cur.motion_y.at(x, y), -2.f, h + 1);
  const float x0 = std::floor(px), y0 = std::floor(py), fx = px - x0, fy = py - y0;

  Reprojection r;
  r.first = static_cast<std::ptrdiff_t>(y0) * stride + static_cast<std::ptrdiff_t>(x0);
  const float nx = cur.nx.at(x, y), ny = cur.ny.at(x, y), nz = cur.nz.at(x, y), z = cur.z_in_prev.at(x, y);
  const float tolerance = kDepthSlopes * cur.dz.at(x, y) + kDepthShare * cur.z.at(x, y);
  const float *Z = prev.z.row(0), *NX = prev.nx.row(0), *NY = prev.ny.row(0), *NZ = prev.nz.row(0);
  const auto weight = [&](std::ptrdiff_t tap, float bilinear) {
    const bool depth = std::abs(Z[tap] - z) <= tolerance;
    const bool normal = nx * NX[tap] + ny * NY[tap] + nz * NZ[tap] >= kNormalAgreement;
    return depth & normal ? bilinear : 0.f;
  };
  r.w00 = weight(r.first, (1 - fx) * (1 - fy));
  r.w10 = weight(r.first + 1, fx * (1 - fy));
  r.w01 = weight(r.first + stride, (1 - fx) * fy);
  r.w11 = weight(r.first + stride + 1, fx * fy);
  const float sum = r.w00 + r.w10 + r.w01 + r.w11;
  const float upper = std::max(r.w00, r.w10), lower = std::max(r.w01, r.w11);
  const bool down = lower > upper, right = down ? r.w11 > r.w01 : r.w10 > r.w00;
  r.strongest = r.first + (down ? stride : 0) + (right ? 1 : 0);
  r.found = sum >= kLeastWeight;
  const float scale = r.found ? 1 / sum : 0.f;
  r.w00 *= scale, r.w10 *= scale, r.w01 *= scale, r.w11 *= scale;
  return r;
}

}  // namespace saccade
