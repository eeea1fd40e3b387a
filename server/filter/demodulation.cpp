#include "filter/demodulation.h"

#include <cmath>

namespace saccade {
namespace {

// The filter squares what it gets and adds up: 1e18 leaves room for that in a float.
float boundedOrZero(float v) {
  return std::abs(v) <= 1e18f ? v : 0.f;
}

}  // namespace

std::chrono::nanoseconds demodulate(const FramePair& frames, Demodulation by, const PoolHandle& pool,
                                    IlluminationSamples& out) {
  const Frame &cur = frames.cur, &prev = frames.prev;
  const auto spp1 = static_cast<float>(cur.samples.spp1), spp2 = static_cast<float>(cur.samples.spp2);
  const float share1 = spp1 / (spp1 + spp2), share2 = spp2 / (spp1 + spp2);  // 1/2 each in [E (9)]
  const float difference = frames.is_first ? 0.f : 1.f;
  return pool.forEachRow(cur.height(), [&](int y) {
    const float *I1 = cur.samples.I1.row(y), *I2 = cur.samples.I2.row(y), *I2_prev = prev.samples.I2.row(y);
    const float *A = cur.g.albedo.row(y), *A_prev = prev.g.albedo.row(y);
    const float *E = cur.g.emission.row(y), *E_prev = prev.g.emission.row(y);
    float *i = out.i.row(y), *d = out.d.row(y);
    for (int x = 0; x < cur.width(); ++x) {
      const float i_cur = (share1 * I1[x] + share2 * I2[x] - E[x]) / filterAlbedo(A[x], by);
      const float i1 = (I1[x] - E[x]) / filterAlbedo(A[x], by);
      const float i2_prev = (I2_prev[x] - E_prev[x]) / filterAlbedo(A_prev[x], by);
      i[x] = boundedOrZero(i_cur);
      d[x] = boundedOrZero(i1 - i2_prev) * difference;
    }
  });
}

std::chrono::nanoseconds modulate(const FramePair& frames, Demodulation by, float variance_scale,
                                  const FilterPlanes& filtered, const ImageF& i_prev,
                                  const ImageF& var_i_prev, const PoolHandle& pool, IntensityChange& out) {
  return pool.forEachRow(out.dI.height(), [&](int y) {
    const float *A = frames.cur.g.albedo.row(y), *A_prev = frames.prev.g.albedo.row(y);
    const float *E = frames.cur.g.emission.row(y), *E_prev = frames.prev.g.emission.row(y);
    const float *Di = filtered.i.row(y), *Dd = filtered.d.row(y), *Di_prev = i_prev.row(y);
    const float *Vd = filtered.var_d.row(y), *Vi_prev = var_i_prev.row(y);
    float *dI = out.dI.row(y), *I_prev = out.I_prev.row(y), *I_now = out.I_now.row(y);
    float *var_dI = out.var_dI.row(y), *var_I_prev = out.var_I_prev.row(y);
    for (int x = 0; x < out.dI.width(); ++x) {
      const float a = modulationAlbedo(A[x], by), a_prev = modulationAlbedo(A_prev[x], by);
      const float da = a - a_prev;
      dI[x] = a * Dd[x] + da * Di_prev[x] + (E[x] - E_prev[x]);
      I_prev[x] = std::max(0.f, a_prev * Di_prev[x] + E_prev[x]);
      I_now[x] = std::max(0.f, a * Di[x] + E[x]);
      var_dI[x] = variance_scale * (a * a * Vd[x] + da * da * Vi_prev[x]);
      var_I_prev[x] = variance_scale * a_prev * a_prev * Vi_prev[x];
    }
  });
}

}  // namespace saccade
