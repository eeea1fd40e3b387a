#include "scene/gltf/gltf_defaults.h"

#include "scene/default_view.h"

namespace saccade {

void addDefaults(Scene& scene) {
  if (scene.paths.empty()) addDefaultCamera(scene);
  if (isLit(scene)) return;
  scene.environment = Environment{{1, 1, 1}, {}, {}};
  scene.unread.push_back("the file has no light; an even sky of radiance 1 lights it");
}

}  // namespace saccade
