// Compiles the stages for one width of lanes.
#pragma once

#include "render/paths/bounce_stage.h"
#include "render/paths/direct_light_stage.h"
#include "render/paths/trace_batch.h"

namespace saccade::detail {

template <int W, int C, bool kMixed, bool kParts>
void traceBatch(const Tracing& t, const SurfaceStages<C>& stages, LivePaths<C>& now, LivePaths<C>& next,
                PathResults<C>& results) {
  Batch<C> b{t, stages, results, &now, &next};
  for (; b.now->count > 0; ++b.vertex) {
    if (kParts && b.vertex == 0)
      directLight<W, C, kMixed, kParts>(b);
    else
      directLight<W, C, kMixed, false>(b);
    b.next->count = 0;
    bounce<W, C, kMixed, kParts>(b);
    std::swap(b.now, b.next);
  }
}

template <int W, int C>
TraceBatch<C> batchTracer(bool mixed, bool parts) {
  if (mixed) return parts ? traceBatch<W, C, true, true> : traceBatch<W, C, true, false>;
  return parts ? traceBatch<W, C, false, true> : traceBatch<W, C, false, false>;
}

}  // namespace saccade::detail
