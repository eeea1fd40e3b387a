// Uniform cubic B-splines that repeat for ever: their second derivatives are continuous.
#pragma once

#include <vector>

#include "base/units.h"
#include "scene/camera/pose.h"

namespace saccade {

// The curve at `u` of a closed loop of at least one control point. It goes by control i at u = i, within the
// hull of that point and its two neighbours.
Vec3d loopAt(const std::vector<Vec3d>& controls, double u);

// A camera path. The rotation is the cumulative B-spline of [Kim, Kim, Shin 1995].
struct SplinePath {
  TimeNs period;               // > 0
  std::vector<Pose> controls;  // T_world_camera, evenly in time, at least one

  Pose at(TimeNs t) const;
  Velocity velocityAt(TimeNs t) const;
};

}  // namespace saccade
