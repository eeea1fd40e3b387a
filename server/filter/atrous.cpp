#include "filter/atrous.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace saccade {
namespace {

constexpr int kChunk = 128;                          // pixels whose sums stay in the first-level cache
constexpr float kKernel[3] = {1, 2.f / 3, 1.f / 6};  // h(q), separable, by distance
constexpr float kGauss[2] = {1.f / 2, 1.f / 4};      // g_3x3, separable, by distance

// Features of one frame at the pixels of a chunk.
struct Features {
  Features(const GBuffer& g, int x0, int y, int n, const AtrousParams& params)
      : z(g.z.row(y) + x0), nx(g.nx.row(y) + x0), ny(g.ny.row(y) + x0), nz(g.nz.row(y) + x0) {
    const float* dz = g.dz.row(y) + x0;
    for (int x = 0; x < n; ++x) r_z[x] = depthFactor(params.sigma_z, z[x], dz[x], params.least_slope);
  }
  const float *z, *nx, *ny, *nz;
  alignas(64) float r_z[kChunk];
};

// One signal at the pixels of a chunk, and the sums of its filter. The centre counts fully.
struct Channel {
  // With `repeat_edge` the variance repeats its edge outside the picture [ours].
  Channel(const ImageF& signal, const ImageF& variance, int x0, int y, int n, float sigma_l, bool repeat_edge)
      : c(signal.row(y) + x0), v(variance.row(y) + x0) {
    const std::ptrdiff_t stride = variance.stride();
    const std::ptrdiff_t up = !repeat_edge || y > 0 ? -stride : 0;
    const std::ptrdiff_t down = !repeat_edge || y + 1 < variance.height() ? stride : 0;
    for (int x = 0; x < n; ++x) {
      const std::ptrdiff_t left = !repeat_edge || x0 + x > 0 ? -1 : 0;
      const std::ptrdiff_t right = !repeat_edge || x0 + x + 1 < variance.width() ? 1 : 0;
      const auto across = [&](const float* p) { return kGauss[0] * p[0] + kGauss[1] * (p[left] + p[right]); };
      const float* p = v + x;
      r_l[x] =
          luminanceFactor(sigma_l, kGauss[0] * across(p) + kGauss[1] * (across(p + up) + across(p + down)));
      w_sum[x] = 1, c_sum[x] = c[x], v_sum[x] = v[x];
    }
  }

  void store(int n, float* c_out, float* v_out) const {
    for (int x = 0; x < n; ++x) {
      const float inv = 1 / w_sum[x];
      c_out[x] = c_sum[x] * inv;
      v_out[x] = v_sum[x] * inv * inv;
    }
  }

  const float *c, *v;
  alignas(64) float r_l[kChunk], w_sum[kChunk], c_sum[kChunk], v_sum[kChunk];
};

// e_z + e_n between each pixel and its neighbour at `o`. s_n = sigma_n log2 e.
inline float featureExponent(const Features& f, int x, std::ptrdiff_t o, float s_n, float inv_distance) {
  const float cosine = f.nx[x] * f.nx[x + o] + f.ny[x] * f.ny[x + o] + f.nz[x] * f.nz[x + o];
  return s_n * (1 - cosine) + std::abs(f.z[x] - f.z[x + o]) * (f.r_z[x] * inv_distance);
}

inline void addTap(Channel& s, int x, std::ptrdiff_t o, float h, float exponent) {
  const float w = h * fastExp2(-(exponent + std::abs(s.c[x] - s.c[x + o]) * s.r_l[x]));
  s.w_sum[x] += w;
  s.c_sum[x] += w * s.c[x + o];
  s.v_sum[x] += w * w * s.v[x + o];
}

enum class Signal { kPrimal, kBoth, kBothHeedingPrev };

template <Signal What>
void filterChunk(const Features& cur, const Features& prev, int n, std::ptrdiff_t stride, int step,
                 float sigma_n, Channel& primal, Channel& difference) {
  const float s_n = sigma_n * kLog2E;
  for (int dy = -2; dy <= 2; ++dy) {
    for (int dx = -2; dx <= 2; ++dx) {
      if (dx == 0 && dy == 0) continue;
      const std::ptrdiff_t o = step * (dy * stride + dx);
      const float h = kKernel[std::abs(dx)] * kKernel[std::abs(dy)];
      const float inv_distance =
          1 / (static_cast<float>(step) * std::hypot(static_cast<float>(dx), static_cast<float>(dy)));
#pragma GCC ivdep
      for (int x = 0; x < n; ++x) {
        const float e_cur = featureExponent(cur, x, o, s_n, inv_distance);
        addTap(primal, x, o, h, e_cur);
        if (What == Signal::kBoth) addTap(difference, x, o, h, e_cur);
        if (What != Signal::kBothHeedingPrev) continue;
        addTap(difference, x, o, h, e_cur + featureExponent(prev, x, o, s_n, inv_distance));
      }
    }
  }
}

}  // namespace

std::chrono::nanoseconds atrousIteration(const FramePair& frames, const AtrousParams& params, int step,
                                         const FilterPlanes& in, const PoolHandle& pool, FilterPlanes& out) {
  static_assert(2 * kMaxAtrousStep <= ImageF::kBorder);
  SACCADE_CHECK(step <= kMaxAtrousStep);
  const int width = in.i.width();
  const auto filter = !params.difference ? filterChunk<Signal::kPrimal>
                      : !params.use_prev ? filterChunk<Signal::kBoth>
                                         : filterChunk<Signal::kBothHeedingPrev>;
  return pool.forEachRow(in.i.height(), [&](int y) {
    for (int x0 = 0; x0 < width; x0 += kChunk) {
      const int n = std::min(kChunk, width - x0);
      // A count of 0 skips the planes that the filter does not read.
      const int n_diff = params.difference ? n : 0, n_prev = params.use_prev ? n_diff : 0;
      const Features cur(frames.cur.g, x0, y, n, params), prev(frames.prev.g, x0, y, n_prev, params);
      Channel primal(in.i, in.var_i, x0, y, n, params.sigma_l, params.repeat_edge_variance);
      Channel difference(in.d, in.var_d, x0, y, n_diff, params.sigma_l_diff, params.repeat_edge_variance);
      filter(cur, prev, n, in.i.stride(), step, params.sigma_n, primal, difference);
      primal.store(n, out.i.row(y) + x0, out.var_i.row(y) + x0);
      difference.store(n_diff, out.d.row(y) + x0, out.var_d.row(y) + x0);
    }
  });
}

}  // namespace saccade
