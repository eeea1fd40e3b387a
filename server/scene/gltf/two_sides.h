// Light from both sides of a surface: a lamp of ours emits from its front.
#pragma once

#include "scene/scene.h"

namespace saccade {

// Whether a placed mesh has an edge that is part of one triangle alone, so that its back can be seen. Corners
// at equal places are one.
bool isOpen(const Mesh& mesh);

// Returns the surface turned round, and moved to behind the given one by 1e-4 of its size.
Mesh backOf(const Mesh& mesh);

}  // namespace saccade
