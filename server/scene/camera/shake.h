// The motion of a hand-held camera.
#pragma once

#include "scene/camera/image_speed.h"
#include "scene/camera/motion.h"

namespace saccade {

// Periodic. `speed` is the median speed of the images of `view`, in focal lengths per second; it is less
// where it would take a swing of half a radian.
Trajectory makeShake(const Pose& start, const VisiblePoints& view, double speed, std::uint64_t seed);

}  // namespace saccade
