// A hash of a scene, for the names of cached references.
#pragma once

#include <cstdint>

#include "scene/scene.h"

namespace saccade::eval {

// Covers all that pictures of the scene depend on, but for strengths over time. Samples textures at 64 x 64
// places.
std::uint64_t hashScene(const Scene& scene);

}  // namespace saccade::eval
