#include "filter/temporal_gradient.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/hash_rng.h"
#include "filter/edge_stopping.h"
#include "filter/surface_test.h"
#include "frame/illumination.h"
#include "frame/pixel_before.h"

namespace saccade {
namespace {

constexpr float kSigmaZ = 1, kSigmaN = 128;  // of SVGF

}  // namespace

TemporalGradient::TemporalGradient(int width, int height, int iterations)
    : width_(width),
      height_(height),
      columns_((width + kEdge - 1) / kEdge),
      rows_((height + kEdge - 1) / kEdge),
      iterations_(iterations),
      guides_(indexOf(0, rows_)),
      gradients_(guides_.size()),
      scratch_(guides_.size()) {}

float TemporalGradient::change(int x, int y) const {
  const Gradient& of = gradients_[indexOf(x / kEdge, y / kEdge)];
  return of.larger > 0 ? std::min(1.f, std::abs(of.delta) / of.larger) : 0;
}

std::chrono::nanoseconds TemporalGradient::estimate(const FramePair& frames, const PoolHandle& pool) {
  auto time = pool.forEachRow(rows_, [&](int row) {
    for (int column = 0; column < columns_; ++column) sample(frames, column, row);
  });
  for (int k = 0; k < iterations_; ++k) {
    time += pool.forEachRow(rows_, [&](int row) {
      for (int column = 0; column < columns_; ++column)
        scratch_[indexOf(column, row)] = filtered(column, row, 1 << k);
    });
    std::swap(gradients_, scratch_);
  }
  return time;
}

// The paper chooses a pixel of the frame before and projects it forward. This filter chooses a pixel of this
// frame, whose pass 1 starts at the point that pixelBefore() showed. Both frames shade one point either way.
// Light is demodulated: pass 1 is scaled as if it came off the albedo at the centre of the pixel [ours].
void TemporalGradient::sample(const FramePair& frames, int column, int row) {
  const Frame &now = frames.cur, &before = frames.prev;
  const GBuffer& g = now.g;
  const std::size_t stratum = indexOf(column, row);
  const std::uint64_t chosen = hashKey(hashKey(now.index, stratum), kEdge) % (kEdge * kEdge);
  const int x = std::min(kEdge * column + static_cast<int>(chosen) % kEdge, width_ - 1);
  const int y = std::min(kEdge * row + static_cast<int>(chosen) / kEdge, height_ - 1);
  guides_[stratum] = {g.z.at(x, y), depthFactor(kSigmaZ, g.z.at(x, y), g.dz.at(x, y), kLeastSlope),
                      g.nx.at(x, y), g.ny.at(x, y), g.nz.at(x, y)};
  const PixelPlace p = pixelBefore(g, x, y);
  const float i = illuminationOf(g, x, y, now.samples.I1.at(x, y));
  const float i_before = illuminationOf(before.g, p.x, p.y, before.samples.I2.at(p.x, p.y));
  const float delta = i - i_before, larger = std::max(i, i_before);
  const bool same = SameSurface(g, before.g, x, y)(p.y * before.g.z.stride() + p.x);
  const bool known = same && !frames.is_first && std::isfinite(delta);
  gradients_[stratum] = known ? Gradient{delta, larger, true} : Gradient{};
}

// 3x3 taps {1, 1/2}, three iterations by default, as in the authors' later filter (Q2RTX). The features stop
// it as they stop SVGF.
TemporalGradient::Gradient TemporalGradient::filtered(int column, int row, int step) const {
  const Guide& centre = guides_[indexOf(column, row)];
  float sum = 0, delta = 0, larger = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const int u = column + dx * step, v = row + dy * step;
      if (u < 0 || v < 0 || u >= columns_ || v >= rows_) continue;
      const Gradient& of = gradients_[indexOf(u, v)];
      if (!of.known) continue;
      const Guide& at = guides_[indexOf(u, v)];
      const float cosine = centre.nx * at.nx + centre.ny * at.ny + centre.nz * at.nz;
      const float distance =
          static_cast<float>(kEdge * step) * std::hypot(static_cast<float>(dx), static_cast<float>(dy));
      const float slope = distance > 0 ? centre.r_z / distance : 0;
      const float e = kSigmaN * kLog2E * (1 - cosine) + std::abs(centre.z - at.z) * slope;
      const float w = (dx == 0 ? 1.f : 0.5f) * (dy == 0 ? 1.f : 0.5f) * fastExp2(-e);
      sum += w, delta += w * of.delta, larger += w * of.larger;
    }
  }
  return sum > 0 ? Gradient{delta / sum, larger / sum, true} : Gradient{};
}

}  // namespace saccade
