// What the levels of a grid say at their own vertices.
#pragma once

#include "base/pool_handle.h"
#include "cache/baked_level.h"
#include "cache/surface_grid.h"

namespace saccade {

// The light at a vertex that is the finest around: 1, rest, visibility, their variances, and those of a step
// over the length of a cell if they went on growing with its square.
enum BakedLane { kKnown, kRest, kVisibility, kVarRest, kVarVisibility, kStepRest, kStepVisibility };

// Blends the levels above level l at each of its vertices, of those with samples enough around them.
BakedLevel blendAtVertices(const GridLevels& grid, int l, const GridParams& params, const PoolHandle& pool);

}  // namespace saccade
