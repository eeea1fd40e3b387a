// The state of grids, as bytes.
#pragma once

#include "base/bytes.h"
#include "cache/grid/bounce_grid.h"
#include "cache/grid/grid_levels.h"

namespace saccade {

void writeLevels(const GridLevels& levels, ByteWriter& out);
void writeBounces(const BounceGrid& bounces, ByteWriter& out);

// The same, with equal indices. Throw std::runtime_error where the bytes are no such thing. `bounces` is
// empty before.
GridLevels readLevels(ByteReader& in);
void readBounces(ByteReader& in, BounceGrid& bounces);

}  // namespace saccade
