// The screw motion of SE(3): a body that turns and moves at constant velocity.
#pragma once

#include "scene/camera/pose.h"

namespace saccade {

// Below this angle the closed forms lose digits and the first terms of their series are exact.
inline constexpr double kSmallAngle = 1e-4;

// The place of the body after one unit of time. It turns by `turn`, a vector of radians, and moves by
// `travel`, both in its own axes.
Pose screwStep(Vec3d turn, Vec3d travel);

}  // namespace saccade
