// Traces a batch of paths, stage by stage, with lanes of one instruction set.
#pragma once

#include "render/paths/surface_stages.h"

namespace saccade {

// Traces all of `now`, and leaves what each has found at its slot of `results`. `next` is scratch memory.
template <int C>
using TraceBatch = void (*)(const Tracing& t, const SurfaceStages<C>& stages, LivePaths<C>& now,
                            LivePaths<C>& next, PathResults<C>& results);

// The kind of a batch's paths, for which stages are compiled.
struct PathKind {
  int channels;  // of light, 1 or 3
  bool mixed;    // surfaces are not all diffuse, or let light through
  bool split;    // light comes in components, see PathResults
};

// See PathKind.
template <int C>
TraceBatch<C> batchTracerAvx2(bool mixed, bool split);
template <int C>
TraceBatch<C> batchTracerAvx512(bool mixed, bool split);

}  // namespace saccade
