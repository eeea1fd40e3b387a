// Compiles the stages for one width of lanes.
#pragma once

#include "render/paths/bounce_stage.h"
#include "render/paths/direct_light_stage.h"
#include "render/paths/trace_batch.h"

namespace saccade::detail {

template <int W, PathKind K>
void traceBatch(const Tracing& t, const SurfaceStages<K.channels>& stages, LivePaths<K.channels>& now,
                LivePaths<K.channels>& next, PathResults<K.channels>& results) {
  constexpr PathKind kLater{K.channels, K.mixed, false};  // direct light is split at the first vertex alone
  Batch<K.channels> b{t, stages, results, &now, &next};
  for (; b.now->count > 0; ++b.vertex) {
    if (K.split && b.vertex == 0)
      directLight<W, K>(b);
    else
      directLight<W, kLater>(b);
    b.next->count = 0;
    bounce<W, K>(b);
    std::swap(b.now, b.next);
  }
}

template <int W, int C>
TraceBatch<C> batchTracer(bool mixed, bool split) {
  if (mixed) return split ? traceBatch<W, PathKind{C, true, true}> : traceBatch<W, PathKind{C, true, false}>;
  return split ? traceBatch<W, PathKind{C, false, true}> : traceBatch<W, PathKind{C, false, false}>;
}

}  // namespace saccade::detail
