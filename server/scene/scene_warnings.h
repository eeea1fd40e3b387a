// Warnings of a scene that can be opened, for its users.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace saccade {

// One sentence each: what of a mesh file is not read, once for each file; what of the scene is not; and that
// there is no light. Empty:
// there is nothing to tell.
std::vector<std::string> warningsOf(const Scene& scene);

}  // namespace saccade
