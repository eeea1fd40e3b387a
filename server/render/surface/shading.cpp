#include "render/surface/shading.h"

namespace saccade {

Shading shadingOf(const Scene& scene) {
  Shading needed;
  needed.extras = scene.environment || !scene.point_lights.empty() || !scene.spot_lights.empty() ||
                  !scene.directional_lights.empty();
  for (const Material& m : scene.materials) {
    needed.kinds |= only(m.model.kind);
    needed.textures |= isTextured(m);
    needed.extras |= !isOpaque(m) || isBumpy(m) || isTextured(m.emission);
  }
  return needed;
}

}  // namespace saccade
