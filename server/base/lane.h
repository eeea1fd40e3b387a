// The lane type of shading code: what one path computes at a time. A float today; a vector of floats is to
// take its place without touching the formulas, so that code uses select() with masks and no branches on
// Lane.
#pragma once

namespace saccade {

using Lane = float;
using LaneMask = bool;

inline Lane select(LaneMask mask, Lane yes, Lane no) {
  return mask ? yes : no;
}

}  // namespace saccade
