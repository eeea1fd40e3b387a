#include "render/features/features.h"

namespace saccade {

bool hasBumpMaps(const Scene& scene) {
  return anyMaterial(scene, isBumpy);
}

void leaveOutBumpMaps(Scene& scene) {
  for (Material& m : scene.materials) m.height = {}, m.height_scale = 1;
}

}  // namespace saccade
