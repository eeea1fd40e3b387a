// A smooth random path about a pose.
#pragma once

#include "scene/camera/image_speed.h"
#include "scene/camera/sine_path.h"

namespace saccade {

// Bounds of the turns from the middle, in radians; and of the way from it, as a share of the depth of the
// nearest surface.
inline constexpr double kMaxRandomPan = 0.3, kMaxRandomTilt = 0.2, kMaxRandomRoll = 0.1,
                        kMaxRandomReach = 0.25;
inline constexpr TimeNs kMinRandomPeriod{10'000'000}, kMaxRandomPeriod{1'000'000'000'000'000'000};

// The seed draws three sines for each of the six axes, and so where the path begins. The speed sets the
// period alone, within its bounds. It is the median speed of the images, in focal lengths per second. All the
// way, surfaces are taken to be as far away as those of `view`.
SinePath makeRandomPath(const Pose& middle, const VisiblePoints& view, double speed, std::uint64_t seed,
                        const Lens& lens);

}  // namespace saccade
