#include "filter/variance.h"

#include <algorithm>
#include <cmath>

namespace saccade {
namespace {

constexpr int kRadius = 3;
constexpr int kChunk = 32;
constexpr float kSpatialSigmaZ = 3;  // [Falcor]

// Sums over the 7x7 pixels around each pixel of a chunk.
struct Sums {
  alignas(64) float w[kChunk], c[kChunk], first[kChunk], second[kChunk];
};

// Adds the neighbours at `o` to the sums of one signal c with moments (first, second). `e` is the exponent of
// the feature weights.
void addTap(int n, const float* e, std::ptrdiff_t o, float r_l, const float* c, const float* first,
            const float* second, Sums& s) {
#pragma GCC ivdep
  for (int x = 0; x < n; ++x) {
    const float w = fastExp2(-(e[x] + std::abs(c[x] - c[x + o]) * r_l));
    s.w[x] += w;
    s.c[x] += w * c[x + o];
    s.first[x] += w * first[x + o];
    s.second[x] += w * second[x + o];
  }
}

// Adds e_z + e_n of one frame's features for the neighbours at `o`, `distance` > 0 pixels away.
void addFeatures(int n, const GBuffer& g, int x0, int y, std::ptrdiff_t o, float distance,
                 const VarianceParams& params, float* e) {
  const float *z = g.z.row(y) + x0, *dz = g.dz.row(y) + x0;
  const float *nx = g.nx.row(y) + x0, *ny = g.ny.row(y) + x0, *nz = g.nz.row(y) + x0;
  const float s_n = params.sigma_n * kLog2E, least_slope = params.least_slope, inv_distance = 1 / distance;
#pragma GCC ivdep
  for (int x = 0; x < n; ++x) {
    const float cosine = nx[x] * nx[x + o] + ny[x] * ny[x + o] + nz[x] * nz[x + o];
    e[x] += s_n * (1 - cosine) +
            std::abs(z[x] - z[x + o]) * depthFactor(kSpatialSigmaZ, z[x], dz[x], least_slope) * inv_distance;
  }
}

void spatialChunk(const FramePair& frames, const History& h, const VarianceParams& params, int x0, int y,
                  int n, Sums& primal, Sums& difference) {
  const float r_l = kLog2E / params.sigma_l;
  primal = {}, difference = {};
  for (int dy = -kRadius; dy <= kRadius; ++dy) {
    for (int dx = -kRadius; dx <= kRadius; ++dx) {
      const std::ptrdiff_t o = dy * h.I.stride() + dx;
      const float distance = std::hypot(static_cast<float>(dx), static_cast<float>(dy));
      alignas(64) float e[kChunk] = {};
      if (o != 0) addFeatures(n, frames.cur.g, x0, y, o, distance, params, e);
      addTap(n, e, o, r_l, h.I.row(y) + x0, h.m1.row(y) + x0, h.m2.row(y) + x0, primal);
      if (!params.difference) continue;
      if (o != 0 && params.use_prev) addFeatures(n, frames.prev.g, x0, y, o, distance, params, e);
      addTap(n, e, o, r_l, h.D.row(y) + x0, h.q1.row(y) + x0, h.q2.row(y) + x0, difference);
    }
  }
}

// Replaces signal and variance where the history is short.
void mergeChunk(int n, const float* length, const Sums& s, float least, float* c, float* variance) {
  for (int x = 0; x < n; ++x) {
    if (length[x] >= kTemporalFrames) continue;
    const float first = s.first[x] / s.w[x], second = s.second[x] / s.w[x];
    c[x] = s.c[x] / s.w[x];
    variance[x] = std::max(least, second - first * first) * (kTemporalFrames / length[x]);
  }
}

// Variance of one frame's sample from its accumulated moments.
void temporalVariance(int width, const float* first, const float* second, float* variance) {
  for (int x = 0; x < width; ++x) variance[x] = std::max(0.f, second[x] - first[x] * first[x]);
}

}  // namespace

std::chrono::nanoseconds estimateVariance(const FramePair& frames, const History& history,
                                          const VarianceParams& params, const PoolHandle& pool,
                                          FilterPlanes& out) {
  const int width = history.I.width();
  return pool.forEachRow(history.I.height(), [&](int y) {
    std::copy_n(history.I.row(y), width, out.i.row(y));
    temporalVariance(width, history.m1.row(y), history.m2.row(y), out.var_i.row(y));
    if (params.difference) {
      std::copy_n(history.D.row(y), width, out.d.row(y));
      temporalVariance(width, history.q1.row(y), history.q2.row(y), out.var_d.row(y));
    }
    const float* length = history.length.row(y);
    for (int x0 = 0; x0 < width; x0 += kChunk) {
      const int n = std::min(kChunk, width - x0);
      if (*std::min_element(length + x0, length + x0 + n) >= kTemporalFrames) continue;
      Sums primal, difference;
      spatialChunk(frames, history, params, x0, y, n, primal, difference);
      mergeChunk(n, length + x0, primal, params.least_variance, out.i.row(y) + x0, out.var_i.row(y) + x0);
      if (params.difference)
        mergeChunk(n, length + x0, difference, params.least_variance, out.d.row(y) + x0,
                   out.var_d.row(y) + x0);
    }
  });
}

}  // namespace saccade
