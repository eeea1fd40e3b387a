// A hash of a scene.
#pragma once

#include <cstdint>

#include "scene/scene.h"

namespace saccade {

// Covers all that pictures of the scene depend on, but for strengths over time. Samples textures at 64 x 64
// places.
std::uint64_t hashScene(const Scene& scene);

}  // namespace saccade
