// The features of a model, one file each: whether a scene has it, and the scene without it.
#pragma once

#include <algorithm>

#include "scene/scene.h"

namespace saccade {

// Textures of colours. Heights and opacities belong to bump maps and masks.
bool hasTextures(const Scene& scene);
void leaveOutTextures(Scene& scene);

bool hasSpecular(const Scene& scene);
void leaveOutSpecular(Scene& scene);

bool hasBumpMaps(const Scene& scene);
void leaveOutBumpMaps(Scene& scene);

bool hasMasks(const Scene& scene);
void leaveOutMasks(Scene& scene);

bool hasEnvironmentPicture(const Scene& scene);
void leaveOutEnvironmentPicture(Scene& scene);

bool hasMips(const Scene& scene);
void leaveOutMips(Scene& scene);

// Functions that several features use.

// The mean over one period of the texture.
Rgb meanOf(const Scene& scene, const SurfaceColor& c);

template <class Test>
bool anyMaterial(const Scene& scene, Test test) {
  return std::any_of(scene.materials.begin(), scene.materials.end(), test);
}

// Erases the shapes of the materials that `gone` has set. Lamps of these materials stay, and reflect nothing.
void removeSurfaces(Scene& scene, const std::vector<bool>& gone);

}  // namespace saccade
