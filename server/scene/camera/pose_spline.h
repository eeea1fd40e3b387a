// Cubic interpolation of timed poses.
#pragma once

#include <cstddef>
#include <span>

#include "scene/camera/trajectory.h"

namespace saccade {

// The pose between keys[i - 1] (s = 0, whose bits it returns) and keys[i] (s = 1). Over all keys the
// curve is C1 and goes through every one. The linear velocity is in world axes, and the angular one in
// the camera's own. At a key the velocity is that of the parabola through the key and its two neighbours.
// At the first and the last key it is the mean velocity to the one neighbour. It is 0 where position or
// rotation does not change on one side, so that a standing camera stands exactly. Position: cubic
// Hermite. Rotation: its like on SO(3), the cumulative Bezier curve of [Kim, Kim, Shin 1995].
Pose interpolateCubic(std::span<const TimedPose> keys, std::size_t i, double s);
// Its derivative by time.
Velocity cubicVelocity(std::span<const TimedPose> keys, std::size_t i, double s);

}  // namespace saccade
