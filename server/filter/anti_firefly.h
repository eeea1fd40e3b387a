// Removes single bright pixels: a rank-conditioned rank-selection filter over 3x3 pixels (Hardie and Boncelet
// 1993) [RELAX].
#pragma once

#include "base/pool_handle.h"
#include "filter/filter_planes.h"
#include "frame/frame.h"

namespace saccade {

// A signal that is above all its neighbours on the same surface becomes the largest of them, and one below
// them the smallest. For the difference, both frames must show one surface. A pixel without such neighbours
// stays. `out` has the variances of `in`.
std::chrono::nanoseconds removeFireflies(const FramePair& frames, const FilterPlanes& in,
                                         const PoolHandle& pool, FilterPlanes& out);

}  // namespace saccade
