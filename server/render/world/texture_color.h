// The colour of a diffuse surface with a texture.
#pragma once

#include "render/world/posed_scene.h"

namespace saccade {

// Its reflectance at a hit, over a footprint at a right angle to the ray, in scene units. `cosine` is that
// between the normal and the ray's reverse.
Rgb textureColor(const PosedScene& posed, const Hit& hit, float cosine, float footprint);

}  // namespace saccade
