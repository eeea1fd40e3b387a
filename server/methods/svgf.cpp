#include "methods/svgf.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "filter/demodulation.h"

namespace saccade {
namespace {

using P = SvgfParams;

const std::vector<ParamField<P>>& fields() {
  static const std::vector<ParamField<P>> table = withCommonFields<P>({
      {"as_falcor", &P::as_falcor, 0, 1,
       "1: with the known faults of Falcor's SVGF pass (depth test, borders, 8-bit albedo)", "Falcor"},
  });
  return table;
}

// The switches of as_falcor.
struct Variant {
  SurfaceTest surface_test;
  Demodulation demodulation;
  float least_slope, least_variance;
  bool repeat_edge_variance;
};
constexpr Variant kCorrected{SurfaceTest::kSameSurface, Demodulation::kAlbedo, kLeastSlope, 0, true};
constexpr Variant kFalcor{SurfaceTest::kFalcorSurface, Demodulation::kEightBits, kFalcorLeastSlope,
                          std::numeric_limits<float>::lowest(), false};

const Variant& variantOf(const P& params) {
  return params.as_falcor ? kFalcor : kCorrected;
}

std::chrono::nanoseconds replaceKnown(const Frame& frame, const ImageF& known, const PoolHandle& pool,
                                      ImageF& i) {
  return pool.forEachRow(frame.height(), [&](int y) {
    for (int x = 0; x < frame.width(); ++x)
      if (!frame.surfaces->hasUncacheable(x, y)) i.at(x, y) = known.at(x, y);
  });
}

}  // namespace

MethodInfo Svgf::info() {
  return {"svgf", "SVGF: fresh seeds, filters each frame by itself, then takes the difference",
          paramSpecs(fields()),
          [](const ParamValues& values) -> SeedPlanner {
            return seedsWith<SeedPlan::independent>(makeParams(fields(), values).independent_numbers);
          },
          [](const MethodSetup& setup) -> std::unique_ptr<Method> {
            return std::make_unique<Svgf>(makeParams(fields(), setup.params), setup.width, setup.height);
          }};
}

Svgf::Svgf(const SvgfParams& p, int w, int h, const TemporalGradient* gradient)
    : params_(p),
      accumulation_{.alpha = p.alpha,
                    .moments_alpha = p.moments_alpha,
                    .max_history = static_cast<float>(p.max_history),
                    .surface_test = variantOf(p).surface_test,
                    .gradient = gradient},
      variance_{.sigma_l = p.sigma_l,
                .sigma_n = p.sigma_n,
                .difference = false,
                .least_slope = variantOf(p).least_slope,
                .least_variance = variantOf(p).least_variance},
      atrous_{.sigma_z = p.sigma_z,
              .sigma_n = p.sigma_n,
              .sigma_l = p.sigma_l,
              .difference = false,
              .least_slope = variantOf(p).least_slope,
              .repeat_edge_variance = variantOf(p).repeat_edge_variance},
      samples_(w, h),
      history_(w, h),
      history_prev_(w, h),
      filtered_(w, h),
      scratch_(w, h),
      I_prev_(w, h),
      var_I_prev_(w, h) {}

void Svgf::start(const Frame& first, const PoolHandle& pool) {
  start(first, nullptr, pool);
}
void Svgf::estimate(const FramePair& frames, const PoolHandle& pool, IntensityChange& out,
                    StageTimes& times) {
  estimate(frames, nullptr, pool, out, times);
}

void Svgf::start(const Frame& first, const ImageF* known, const PoolHandle& pool) {
  StageTimes unused;
  filter(FramePair::first(first), known, pool, unused);
  remodulate(first, pool, I_prev_, var_I_prev_);
}

void Svgf::estimate(const FramePair& frames, const ImageF* known, const PoolHandle& pool,
                    IntensityChange& out, StageTimes& times) {
  filter(frames, known, pool, times);
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

void Svgf::filter(const FramePair& frames, const ImageF* known, const PoolHandle& pool, StageTimes& times) {
  times[Stage::kModulate] += demodulate(frames, variantOf(params_).demodulation, pool, samples_);
  if (known) times[Stage::kModulate] += replaceKnown(frames.cur, *known, pool, samples_.i);
  std::swap(history_, history_prev_);
  times[Stage::kTemporal] +=
      accumulate(frames, samples_, accumulation_, history_prev_, nullptr, pool, history_);
  filterOverSpace(frames, params_, variance_, atrous_, pool, history_, filtered_, scratch_, times);
}

std::chrono::nanoseconds Svgf::remodulate(const Frame& frame, const PoolHandle& pool, ImageF& I,
                                          ImageF& variance) const {
  const float variance_scale = params_.varianceScale();
  return pool.forEachRow(frame.height(), [&](int y) {
    const float *A = frame.g.albedo.row(y), *E = frame.g.emission.row(y);
    const float *Di = filtered_.i.row(y), *V = filtered_.var_i.row(y);
    float *I_row = I.row(y), *variance_row = variance.row(y);
    for (int x = 0; x < frame.width(); ++x) {
      const float a = modulationAlbedo(A[x], variantOf(params_).demodulation);
      I_row[x] = std::max(0.f, a * Di[x] + E[x]);
      variance_row[x] = variance_scale * a * a * std::max(0.f, V[x]);  // kFalcor: V may be negative
    }
  });
}

}  // namespace saccade
