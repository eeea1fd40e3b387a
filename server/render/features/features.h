// The parts of a model, one file each: whether a scene has it, and the scene without it.
#pragma once

#include <algorithm>

#include "scene/scene.h"

namespace saccade {

// Of the colours. Heights and opacities belong to bump maps and masks.
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

// What they share.

// Over one period of its texture.
Rgb meanOf(const Scene& scene, const SurfaceColor& c);

template <class Test>
bool anyMaterial(const Scene& scene, Test test) {
  return std::any_of(scene.materials.begin(), scene.materials.end(), test);
}

// Erases the shapes of the materials that `gone` has set. Lamps among them stay, and reflect nothing.
void removeSurfaces(Scene& scene, const std::vector<bool>& gone);

}  // namespace saccade
