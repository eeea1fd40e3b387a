// The lane type of shading code: what one path computes at a time. A float today; a vector of floats is to
// take its place without touching the formulas, so that code uses select() with masks and no branches on
// Lane.
#pragma once

#include "base/vec.h"

namespace saccade {

using Lane = float;
using LaneMask = bool;
using LaneVec3 = Vec3T<Lane>;
using LaneRgb = Vec3T<Lane>;

inline Lane select(LaneMask mask, Lane yes, Lane no) {
  return mask ? yes : no;
}
inline LaneVec3 select(LaneMask mask, LaneVec3 yes, LaneVec3 no) {
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}

}  // namespace saccade
