// A number that tells scenes apart.
#pragma once

#include <cstdint>

#include "scene/scene.h"

namespace saccade::eval {

// Takes in all that pictures of a scene show, of textures 64 x 64 places; but no strengths over time.
std::uint64_t hashScene(const Scene& scene);

}  // namespace saccade::eval
