#include "render/features/features.h"

namespace saccade {

bool hasBumpMaps(const Scene& scene) {
  return anyMaterial(scene, isBumpy);
}

void leaveOutBumpMaps(Scene& scene) {
  for (Material& m : scene.materials) m.height = m.normals = {}, m.height_scale = m.normals_scale = 1;
}

}  // namespace saccade
