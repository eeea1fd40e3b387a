#include "scene/gltf/gltf_defaults.h"

#include <algorithm>

#include "scene/default_view.h"

namespace saccade {
namespace {

bool isLit(const Scene& scene) {
  return scene.environment || !scene.point_lights.empty() || !scene.spot_lights.empty() ||
         !scene.directional_lights.empty() ||
         std::ranges::any_of(scene.meshes, [](const Mesh& mesh) { return emits(mesh); });
}

}  // namespace

void addDefaults(Scene& scene) {
  if (scene.paths.empty()) addDefaultCamera(scene);
  if (isLit(scene)) return;
  scene.environment = Environment{{1, 1, 1}, {}, {}};
  scene.unread.push_back("the file has no light; an even sky of radiance 1 lights it");
}

}  // namespace saccade
