// Warnings of a scene that can be opened, for its users.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace saccade {

// One sentence each: what of a mesh file or of the scene's own is not read, and that there is no light. Each
// mesh file is told once. Empty:
// there is nothing to tell.
std::vector<std::string> warningsOf(const Scene& scene);

}  // namespace saccade
