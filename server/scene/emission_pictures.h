// Lights whose radiance is a picture.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace saccade {

// Divides the pictures of Material::emission by their means, once they have been read. Returns the mean of
// each material's picture, which its meshes emit: 1 without one. No other colour may use these pictures.
std::vector<Rgb> takeEmissionMeans(Scene& scene);

}  // namespace saccade
