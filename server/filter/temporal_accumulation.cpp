#include "filter/temporal_accumulation.h"

#include "filter/reprojection.h"

namespace saccade {
namespace {

float mix(float from, float to, float share) {
  return from + share * (to - from);
}

}  // namespace

std::chrono::nanoseconds accumulate(const FramePair& frames, const IlluminationSamples& samples,
                                    const AccumulationParams& params, const History& prev,
                                    const ImageF& I_prev2, TilePool& pool, History& out) {
  const std::ptrdiff_t stride = prev.I.stride();
  const float correction = params.correct_difference ? 1.f : 0.f;
  return pool.forEachRow(samples.i.height(), [&](int y) {
    for (int x = 0; x < samples.i.width(); ++x) {
      const Reprojection W = reproject(frames.cur.g, frames.prev.g, x, y);
      const float i = samples.i.at(x, y), d = samples.d.at(x, y);

      // A history of h frames is their plain mean until 1/h falls below alpha [Falcor].
      const float h = W.found ? std::min(params.max_history, prev.length.row(0)[W.strongest] + 1) : 1.f;
      const float alpha = std::max(params.alpha, 1 / h), alpha_m = std::max(params.moments_alpha, 1 / h);
      out.length.at(x, y) = h;

      // I'_t = alpha I_t + (1 - alpha) W_t I'_{t-1} [E (13)]
      const float R = W(prev.I.row(0), stride);
      out.R.at(x, y) = R;
      out.I.at(x, y) = mix(R, i, alpha);
      out.m1.at(x, y) = mix(W(prev.m1.row(0), stride), i, alpha_m);
      out.m2.at(x, y) = mix(W(prev.m2.row(0), stride), i * i, alpha_m);
      out.q1.at(x, y) = mix(W(prev.q1.row(0), stride), d, alpha_m);
      out.q2.at(x, y) = mix(W(prev.q2.row(0), stride), d * d, alpha_m);

      // D'_t = alpha D_t + (1 - alpha)(W_t D'_{t-1} + W_t I'_{t-2} - R_{t-1}) [E (16)], with R_{t-1} the
      // history looked up at this pixel one frame ago. One alpha for both frames: the exact identity for a
      // changing alpha carries a term of uncorrelated noise that makes a standing scene fire, and is left
      // out. It needs history here now and, at this pixel, one frame ago.
      const bool history = W.found && prev.length.at(x, y) > 1 && params.accumulate_difference;
      const float carried =
          W(prev.D.row(0), stride) + correction * (W(I_prev2.row(0), stride) - prev.R.at(x, y));
      out.D.at(x, y) = history ? mix(carried, d, alpha) : d;
    }
  });
}

}  // namespace saccade
