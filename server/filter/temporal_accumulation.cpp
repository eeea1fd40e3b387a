#include "filter/temporal_accumulation.h"

#include "filter/reprojection.h"
#include "filter/surface_test.h"
#include "filter/temporal_gradient.h"

namespace saccade {
namespace {

float mix(float from, float to, float share) {
  return from + share * (to - from);
}

struct Recursion {
  const FramePair& frames;
  const IlluminationSamples& samples;
  const AccumulationParams& params;
  const History& prev;
  const ImageF* I_prev2;
  History& out;

  template <class Surface>
  void pixel(int x, int y) const {
    const GBuffer &g = frames.cur.g, &g_prev = frames.prev.g;
    const Reprojection W = Reprojection::find(g, g_prev, x, y, Surface(g, g_prev, x, y));
    const float i = samples.i.at(x, y);

    // A history of h frames is their plain mean until 1/h falls below alpha [Falcor].
    // Light that has changed shortens it, so that the variance starts anew too [ours].
    const float lambda = params.gradient ? params.gradient->change(x, y) : 0.f;
    const float older = W.found() ? std::min(params.max_history - 1, prev.length.row(0)[W.strongest()]) : 0.f;
    const float h = 1 + (1 - lambda) * older;
    // alpha_i = (1 - lambda) alpha + lambda [Schied et al. 2018]
    const float alpha = std::max(mix(params.alpha, 1, lambda), 1 / h);
    const float alpha_m = std::max(mix(params.moments_alpha, 1, lambda), 1 / h);
    out.length.at(x, y) = h;

    // I'_t = alpha I_t + (1 - alpha) W_t I'_{t-1} [E (13)]
    const float R = W(prev.I);
    out.I.at(x, y) = mix(R, i, alpha);
    out.m1.at(x, y) = mix(W(prev.m1), i, alpha_m);
    out.m2.at(x, y) = mix(W(prev.m2), i * i, alpha_m);
    if (!I_prev2) return;
    out.R.at(x, y) = R;
    difference(x, y, W, alpha, alpha_m);
  }

  // D'_t = alpha D_t + (1 - alpha)(W_t D'_{t-1} + W_t I'_{t-2} - R_{t-1}) [E (16)], with R_{t-1} the history
  // looked up at this pixel one frame ago. Both frames use one alpha. The exact identity for a changing alpha
  // has one more term, of uncorrelated noise, which makes a standing scene fire; it is left out. The pixel
  // needs a history now and one frame ago.
  void difference(int x, int y, const Reprojection& W, float alpha, float alpha_m) const {
    const float d = samples.d.at(x, y), correction = params.correct_difference ? 1.f : 0.f;
    const bool history = W.found() && prev.length.at(x, y) > 1 && params.accumulate_difference;
    const float carried = W(prev.D) + correction * (W(*I_prev2) - prev.R.at(x, y));
    out.D.at(x, y) = history ? mix(carried, d, alpha) : d;
    out.q1.at(x, y) = mix(W(prev.q1), d, alpha_m);
    out.q2.at(x, y) = mix(W(prev.q2), d * d, alpha_m);
  }
};

}  // namespace

std::chrono::nanoseconds accumulate(const FramePair& frames, const IlluminationSamples& samples,
                                    const AccumulationParams& params, const History& prev,
                                    const ImageF* I_prev2, const PoolHandle& pool, History& out) {
  const Recursion recursion{frames, samples, params, prev, I_prev2, out};
  const bool falcor = params.surface_test == SurfaceTest::kFalcorSurface;
  return pool.forEachRow(samples.i.height(), [&](int y) {
    for (int x = 0; x < samples.i.width(); ++x) {
      falcor ? recursion.pixel<FalcorSurface>(x, y) : recursion.pixel<SameSurface>(x, y);
    }
  });
}

}  // namespace saccade
