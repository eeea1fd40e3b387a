// The light and evidence of a grid's levels at their own vertices.
#pragma once

#include "base/pool_handle.h"
#include "cache/bake/baked_level.h"
#include "cache/grid/surface_grid.h"

namespace saccade {

// A point is near a shadow's edge from this part of kLeastShadowContrast on. So one that wants rays had such
// neighbours in the frame before.
inline constexpr float kLeastNearShadow = 0.5f;
inline constexpr float kLeastShadow = 1e-8f;  // of BakedVertex::shadow: less is none

// Blends the levels above level l at each of its vertices, of those with samples enough around them: each
// vertex is the finest around itself. `coarser`: the same of the next level. `scale`: a factor on all light
// but visibility, which should bring it to at most 2^7.
BakedLevel blendAtVertices(const GridLevels& grid, int l, const BakedLevel& coarser, const GridParams& params,
                           float scale, const PoolHandle& pool);

}  // namespace saccade
