// Where a path starts: the first surface that a pixel's ray meets.
#pragma once

#include "render/surface/color.h"
#include "render/surface/surface.h"

namespace saccade {

struct PathStart {
  Surface surface;
  Vec3 direction;  // in which the ray arrived, unit
  RayCone cone;    // at the surface
};

// The most mirrors, panes and masks between a pixel and the surface that guides the filter.
inline constexpr int kMaxViewDepth = 8;

}  // namespace saccade
