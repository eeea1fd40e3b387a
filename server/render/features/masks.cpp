#include "render/features/features.h"

namespace saccade {

bool hasMasks(const Scene& scene) {
  return anyMaterial(scene, [](const Material& m) { return !isOpaque(m); });
}

void leaveOutMasks(Scene& scene) {
  std::vector<bool> gone;
  for (Material& m : scene.materials) {
    gone.push_back(luminance(meanOf(scene, m.opacity)) < 0.5f);
    m.opacity = kWhite;
  }
  removeSurfaces(scene, gone);
}

}  // namespace saccade
