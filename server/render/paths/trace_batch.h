// Traces a batch of paths, stage by stage, with lanes of one instruction set.
#pragma once

#include "render/paths/surface_stages.h"

namespace saccade {

// Traces all of `now`, and leaves what each has found at its slot of `results`. `next` is scratch memory.
template <int C>
using TraceBatch = void (*)(const Tracing& t, const SurfaceStages<C>& stages, LivePaths<C>& now,
                            LivePaths<C>& next, PathResults<C>& results);

// mixed: surfaces are not all diffuse, or let light through. parts: light is told in parts.
template <int C>
TraceBatch<C> batchTracerAvx2(bool mixed, bool parts);
template <int C>
TraceBatch<C> batchTracerAvx512(bool mixed, bool parts);

}  // namespace saccade
