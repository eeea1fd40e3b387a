#include "methods/svgf_common.h"

#include <utility>

namespace saccade {

void filterOverSpace(const FramePair& frames, const SvgfCommonParams& params, const VarianceParams& variance,
                     const AtrousParams& atrous, const PoolHandle& pool, History& history,
                     FilterPlanes& filtered, FilterPlanes& scratch, StageTimes& times) {
  times[Stage::kVariance] += estimateVariance(frames, history, variance, pool, filtered);
  for (int iteration = 0; iteration < params.iterations; ++iteration) {
    times[Stage::kAtrous] += atrousIteration(frames, atrous, 1 << iteration, filtered, pool, scratch);
    std::swap(filtered, scratch);
    if (iteration != params.feedback_tap) continue;
    history.I.copyFrom(filtered.i);
    if (atrous.difference) history.D.copyFrom(filtered.d);
  }
}

}  // namespace saccade
