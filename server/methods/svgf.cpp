#include "methods/svgf.h"

#include <algorithm>
#include <utility>

#include "filter/demodulation.h"

namespace saccade {
namespace {

using P = SvgfParams;

const std::vector<ParamField<P>>& fields() {
  static const std::vector<ParamField<P>> table = withCommonFields<P>({
      {"as_falcor", &P::as_falcor, 0, 1, "with Falcor's known faults: depth test, borders, 8-bit albedo",
       "Falcor"},
  });
  return table;
}

Demodulation demodulation(const P& params) {
  return params.as_falcor ? Demodulation::kEightBits : Demodulation::kAlbedo;
}

}  // namespace

MethodInfo Svgf::info() {
  return {"svgf", "SVGF: each frame filtered by itself, fresh seeds; its difference is taken afterwards",
          paramSpecs(fields()),
          [](const ParamValues& values, int width, int height) -> std::unique_ptr<Method> {
            return std::make_unique<Svgf>(makeParams(fields(), values), width, height);
          }};
}

Svgf::Svgf(const SvgfParams& p, int w, int h)
    : params_(p),
      accumulation_{.alpha = p.alpha,
                    .moments_alpha = p.moments_alpha,
                    .max_history = static_cast<float>(p.max_history),
                    .as_falcor = p.as_falcor},
      variance_{.sigma_l = p.sigma_l, .sigma_n = p.sigma_n, .difference = false, .as_falcor = p.as_falcor},
      atrous_{.sigma_z = p.sigma_z,
              .sigma_n = p.sigma_n,
              .sigma_l = p.sigma_l,
              .difference = false,
              .as_falcor = p.as_falcor},
      samples_(w, h),
      history_(w, h),
      history_prev_(w, h),
      filtered_(w, h),
      scratch_(w, h),
      I_prev_(w, h),
      var_I_prev_(w, h) {}

void Svgf::start(const Frame& first, TilePool& pool) {
  StageTimes unused;
  filter({first, first}, pool, unused);
  remodulate(first, pool, I_prev_, var_I_prev_);
}

void Svgf::estimate(const FramePair& frames, TilePool& pool, IntensityChange& out, StageTimes& times) {
  filter(frames, pool, times);
  std::swap(out.I_prev, I_prev_);
  std::swap(out.var_I_prev, var_I_prev_);
  times[Stage::kModulate] += remodulate(frames.cur, pool, out.I_now, out.var_dI);
  times[Stage::kModulate] += pool.forEachRow(out.dI.height(), [&](int y) {
    const float *I_now = out.I_now.row(y), *I_prev = out.I_prev.row(y), *var_I_prev = out.var_I_prev.row(y);
    float *dI = out.dI.row(y), *var_dI = out.var_dI.row(y);
    float *kept = I_prev_.row(y), *var_kept = var_I_prev_.row(y);
    for (int x = 0; x < out.dI.width(); ++x) {
      kept[x] = I_now[x];
      var_kept[x] = var_dI[x];
      dI[x] = I_now[x] - I_prev[x];
      var_dI[x] += var_I_prev[x];  // as if the two frames were independent: an upper bound
    }
  });
}

void Svgf::filter(const FramePair& frames, TilePool& pool, StageTimes& times) {
  times[Stage::kModulate] += demodulate(frames, demodulation(params_), pool, samples_);
  std::swap(history_, history_prev_);
  times[Stage::kTemporal] +=
      accumulate(frames, samples_, accumulation_, history_prev_, nullptr, pool, history_);
  filterOverSpace(frames, params_, variance_, atrous_, pool, history_, filtered_, scratch_, times);
}

std::chrono::nanoseconds Svgf::remodulate(const Frame& frame, TilePool& pool, ImageF& I,
                                          ImageF& variance) const {
  const float variance_scale = params_.varianceScale();
  return pool.forEachRow(frame.height(), [&](int y) {
    const float *A = frame.g.albedo.row(y), *E = frame.g.emission.row(y);
    const float *Di = filtered_.i.row(y), *V = filtered_.var_i.row(y);
    float *I_row = I.row(y), *variance_row = variance.row(y);
    for (int x = 0; x < frame.width(); ++x) {
      const float a = modulationAlbedo(A[x], demodulation(params_));
      I_row[x] = std::max(0.f, a * Di[x] + E[x]);
      variance_row[x] = variance_scale * a * a * std::max(0.f, V[x]);  // as_falcor: V may be negative
    }
  });
}

}  // namespace saccade
