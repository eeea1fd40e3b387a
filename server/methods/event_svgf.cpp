#include "methods/event_svgf.h"

#include <utility>

#include "filter/demodulation.h"
#include "methods/param_fields.h"

namespace saccade {
namespace {

using P = EventSvgfParams;

const std::vector<ParamField<P>>& fields() {
  static const std::vector<ParamField<P>> table{
      {"alpha", &P::alpha, 0.001, 1, "least weight of the new sample; 1: no history",
       "paper 5.1 (Falcor: 0.05)"},
      {"moments_alpha", &P::moments_alpha, 0.001, 1, "least weight of the new sample in the moments",
       "Falcor"},
      {"max_history", &P::max_history, 1, 1024, "frames after which the history counts as full", "Falcor"},
      {"iterations", &P::iterations, 0, 5, "a-trous iterations, of spacing 1, 2, 4, ...", "Falcor"},
      {"feedback_tap", &P::feedback_tap, -1, 4, "iteration whose result becomes the history; -1: none",
       "Falcor"},
      {"sigma_l", &P::sigma_l, 0.01, 1000, "luminance tolerance of the primal, standard deviations [E (25)]",
       "Falcor"},
      {"sigma_l_diff", &P::sigma_l_diff, 0.01, 1000, "the same for the difference", "Falcor, as sigma_l"},
      {"sigma_n", &P::sigma_n, 0, 1024, "normal exponent [E (24)]", "Falcor"},
      {"sigma_z", &P::sigma_z, 0.01, 1000, "depth tolerance, slopes [E (23)]", "Falcor"},
      {"correlated", &P::correlated, 0, 1, "pass 1 reuses the seeds of the previous frame",
       "paper 4.3, Fig. 9 A"},
      {"w_prev", &P::w_prev, 0, 1, "the difference heeds edges of the previous frame [E (12)]",
       "paper 4.4.1, Fig. 9 B"},
      {"accumulate_difference", &P::accumulate_difference, 0, 1, "the difference is accumulated over time",
       "paper 4.4.2, Fig. 9 C"},
      {"demodulate", &P::demodulate, 0, 1, "light is divided by albedo before filtering",
       "paper 4.4.3, Fig. 9 D"},
      {"correction", &P::correction, 0, 1, "the last two terms of [E (16)]", "paper 4.4.2"},
  };
  return table;
}

Demodulation demodulation(const P& params) {
  return params.demodulate ? Demodulation::kAlbedo : Demodulation::kNone;
}

}  // namespace

MethodInfo EventSvgf::info() {
  return {
      "event_svgf", "EventSVGF: correlated passes, the difference accumulated and filtered beside the primal",
      paramSpecs(fields()), [](const ParamValues& values, int width, int height) -> std::unique_ptr<Method> {
        return std::make_unique<EventSvgf>(makeParams(fields(), values), width, height);
      }};
}

EventSvgf::EventSvgf(const EventSvgfParams& p, int w, int h)
    : params_(p),
      accumulation_{.alpha = p.alpha,
                    .moments_alpha = p.moments_alpha,
                    .max_history = static_cast<float>(p.max_history),
                    .accumulate_difference = p.accumulate_difference,
                    .correct_difference = p.correction},
      variance_{.sigma_l = p.sigma_l, .sigma_n = p.sigma_n, .use_prev = p.w_prev},
      atrous_{.sigma_z = p.sigma_z,
              .sigma_n = p.sigma_n,
              .sigma_l = p.sigma_l,
              .sigma_l_diff = p.sigma_l_diff,
              .use_prev = p.w_prev},
      samples_(w, h),
      history_(w, h),
      history_prev_(w, h),
      I_prev2_(w, h),
      filtered_(w, h),
      scratch_(w, h),
      i_prev_(w, h),
      var_i_prev_(w, h) {}

SeedReuse EventSvgf::seedReuse() const {
  return params_.correlated ? SeedReuse::kCorrelated : SeedReuse::kIndependentPairs;
}

void EventSvgf::start(const Frame& first, TilePool& pool) {
  StageTimes unused;
  // No pixel has a history: lengths are 0, so W_t finds only frames of length 0 and every mean starts anew.
  filter({first, first}, pool, unused);
}

void EventSvgf::estimate(const FramePair& frames, TilePool& pool, IntensityChange& out, StageTimes& times) {
  std::swap(i_prev_, filtered_.i);
  std::swap(var_i_prev_, filtered_.var_i);
  filter(frames, pool, times);
  // Variances so far are of one frame's sample; a running mean of weight alpha has alpha / (2 - alpha) of it.
  const float variance_scale = params_.alpha / (2 - params_.alpha);
  times[Stage::kModulate] +=
      modulate(frames, demodulation(params_), variance_scale, filtered_, i_prev_, var_i_prev_, pool, out);
}

void EventSvgf::filter(const FramePair& frames, TilePool& pool, StageTimes& times) {
  // (A) Samples, demodulated.
  times[Stage::kModulate] += demodulate(frames, demodulation(params_), pool, samples_);

  // (B) Accumulate along the motion vectors. I_prev2_ receives I'_{t-2}; its old storage becomes I'_t.
  std::swap(I_prev2_, history_prev_.I);
  std::swap(history_, history_prev_);
  times[Stage::kTemporal] +=
      accumulate(frames, samples_, accumulation_, history_prev_, &I_prev2_, pool, history_);

  // (C) Filter over space, each iteration twice as wide. One of them is fed back into the history.
  times[Stage::kVariance] += estimateVariance(frames, history_, variance_, pool, filtered_);
  for (int iteration = 0; iteration < params_.iterations; ++iteration) {
    times[Stage::kAtrous] += atrousIteration(frames, atrous_, 1 << iteration, filtered_, pool, scratch_);
    std::swap(filtered_, scratch_);
    if (iteration == params_.feedback_tap) {
      history_.I.copyFrom(filtered_.i);
      history_.D.copyFrom(filtered_.d);
    }
  }
}

}  // namespace saccade
