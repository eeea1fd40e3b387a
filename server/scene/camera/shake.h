// The motion of a hand-held camera.
#pragma once

#include "scene/camera/image_speed.h"
#include "scene/camera/sine_path.h"

namespace saccade {

inline constexpr TimeNs kShakePeriod{2'000'000'000};
// Bounds. The acceleration, per second squared, is that of a hand where a scene unit is a metre. The reach is
// the distance from the start, as a share of the depth of the nearest surface.
inline constexpr double kMaxShakeAcceleration = 4, kMaxShakeReach = 0.25;

// A path from `start`. `speed` is the median speed of the images of `view`, in focal lengths per second. The
// path is slower where that speed would take a swing of half a radian.
SinePath makeShake(const Pose& start, const VisiblePoints& view, double speed, std::uint64_t seed,
                   const Lens& lens);

}  // namespace saccade
