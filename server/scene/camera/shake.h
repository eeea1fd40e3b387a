// The motion of a hand-held camera.
#pragma once

#include "scene/camera/image_speed.h"
#include "scene/camera/motion.h"

namespace saccade {

// A periodic path. `speed` is the median speed of the images of `view`, in focal lengths per second. The path
// is slower where that speed would take a swing of half a radian.
Trajectory makeShake(const Pose& start, const VisiblePoints& view, double speed, std::uint64_t seed,
                     const Lens& lens);

}  // namespace saccade
