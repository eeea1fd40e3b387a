// Where a camera looks along a path.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/roam/panorama.h"

namespace saccade {

// `around`: what can be seen from places along a closed path, a multiple of `aims` of them, at least 8 for
// each. Returns a direction for each place, which turns by at most 35 degrees to the next. The seed draws the
// aims, those with relief rather than others. Between them the camera turns evenly, but rather looks where
// there is more to see.
std::vector<Vec3d> drawGaze(const std::vector<Panorama>& around, const Level& level, std::size_t aims,
                            std::uint64_t seed);

}  // namespace saccade
