#include "methods/event_svgf.h"

#include <utility>

#include "filter/demodulation.h"
#include "filter/motion_alignment.h"

namespace saccade {
namespace {

using P = EventSvgfParams;

const std::vector<ParamField<P>>& fields() {
  static const std::vector<ParamField<P>> table = withCommonFields<P>({
      {"sigma_l_diff", &P::sigma_l_diff, 0.01, 1000, "luminance tolerance of the difference",
       "Falcor, as sigma_l"},
      {"correlated", &P::correlated, 0, 1, "pass 1 reuses the seeds of the previous frame",
       "paper 4.3, Fig. 9 A"},
      {"w_prev", &P::w_prev, 0, 1,
       "edges of the previous frame stop the filter of the difference too [E (12)]", "paper 4.4.1, Fig. 9 B"},
      {"accumulate_difference", &P::accumulate_difference, 0, 1, "the difference is accumulated over time",
       "paper 4.4.2, Fig. 9 C"},
      {"demodulate", &P::demodulate, 0, 1, "light is divided by albedo before filtering",
       "paper 4.4.3, Fig. 9 D"},
      {"correction", &P::correction, 0, 1, "the last two terms of [E (16)]", "paper 4.4.2"},
      {"motion_aligned", &P::motion_aligned, 0, 1,
       "1: the difference follows the surface, and a correction makes it that of the pixel",
       "paper, appendix C"},
  });
  return table;
}

Demodulation demodulation(const P& params) {
  return params.demodulate ? Demodulation::kAlbedo : Demodulation::kNone;
}

// The pass that shares its numbers with the frame before, and its companion.
SeedPlanner seedsOf(const P& p) {
  if (!p.correlated) return seedsWith<SeedPlan::independentPairs>(p.independent_numbers);
  if (p.motion_aligned) return seedsWith<SeedPlan::correlatedAlongMotion>(p.independent_numbers);
  return seedsWith<SeedPlan::correlated>(p.independent_numbers);
}

// Whether the filter of the difference heeds the pixel's own surface of the frame before. The surface that
// the motion leads to is the same.
bool usePrev(const P& p) {
  return p.w_prev && !p.motion_aligned;
}

}  // namespace

MethodInfo EventSvgf::info() {
  return {
      "event_svgf", "EventSVGF: correlated passes, the difference accumulated and filtered beside the primal",
      paramSpecs(fields()), [](const ParamValues& values) { return seedsOf(makeParams(fields(), values)); },
      [](const MethodSetup& setup) -> std::unique_ptr<Method> {
        return std::make_unique<EventSvgf>(makeParams(fields(), setup.params), setup.width, setup.height);
      }};
}

EventSvgf::EventSvgf(const EventSvgfParams& p, int w, int h)
    : params_(p),
      accumulation_{.alpha = p.alpha,
                    .moments_alpha = p.moments_alpha,
                    .max_history = static_cast<float>(p.max_history),
                    .accumulate_difference = p.accumulate_difference,
                    .correct_difference = p.correction && !p.motion_aligned},
      variance_{.sigma_l = p.sigma_l, .sigma_n = p.sigma_n, .use_prev = usePrev(p)},
      atrous_{.sigma_z = p.sigma_z,
              .sigma_n = p.sigma_n,
              .sigma_l = p.sigma_l,
              .sigma_l_diff = p.sigma_l_diff,
              .use_prev = usePrev(p)},
      samples_(w, h),
      history_(w, h),
      history_prev_(w, h),
      I_prev2_(w, h),
      filtered_(w, h),
      scratch_(w, h),
      i_prev_(w, h),
      var_i_prev_(w, h) {}

void EventSvgf::start(const Frame& first, const PoolHandle& pool) {
  StageTimes unused;
  // No pixel has a history: lengths are 0, so W_t finds only frames of length 0 and every mean starts anew.
  filter(FramePair::first(first), pool, unused);
}

void EventSvgf::estimate(const FramePair& frames, const PoolHandle& pool, IntensityChange& out,
                         StageTimes& times) {
  std::swap(i_prev_, filtered_.i);
  std::swap(var_i_prev_, filtered_.var_i);
  filter(frames, pool, times);
  if (params_.motion_aligned) times[Stage::kModulate] += correctAlignment(frames, i_prev_, pool, filtered_);
  times[Stage::kModulate] += modulate(frames, demodulation(params_), params_.varianceScale(), filtered_,
                                      i_prev_, var_i_prev_, pool, out);
}

void EventSvgf::filter(const FramePair& frames, const PoolHandle& pool, StageTimes& times) {
  // (A) Samples, demodulated.
  times[Stage::kModulate] += demodulate(frames, demodulation(params_), pool, samples_);
  if (params_.motion_aligned)
    times[Stage::kModulate] += alignDifference(frames, demodulation(params_), pool, samples_.d);

  // (B) Accumulate along the motion vectors. I_prev2_ receives I'_{t-2}; its old storage becomes I'_t.
  std::swap(I_prev2_, history_prev_.I);
  std::swap(history_, history_prev_);
  times[Stage::kTemporal] +=
      accumulate(frames, samples_, accumulation_, history_prev_, &I_prev2_, pool, history_);

  // (C) Filter over space.
  filterOverSpace(frames, params_, variance_, atrous_, pool, history_, filtered_, scratch_, times);
}

}  // namespace saccade
