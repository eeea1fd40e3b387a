#include "scene/gltf/gltf_sky.h"

#include "scene/gltf/gltf_lights.h"
#include "scene/gltf/gltf_nodes.h"
#include "scene/sky/sky_picture.h"

namespace saccade {
namespace {

Affine turnOf(const JsonNode& sky) {
  const Quaternion q = readRotation(sky);
  return {rotate(q, {1, 0, 0}), rotate(q, {0, 1, 0}), rotate(q, {0, 0, 1}), {}};
}

}  // namespace

void addSky(const GltfFile& file, FileLoads& loads, Scene& scene) {
  const auto of = sceneOf(file.root());
  const auto sky = of ? of->extension("SACCADE_sky") : std::nullopt;
  if (!sky) return;
  const auto [r, g, b] = sky->numbers<3>("radiance", {1, 1, 1});
  scene.environment = Environment{checkedLight(*sky, {r, g, b}), {}, turnOf(*sky)};
  const auto picture = sky->find("picture");
  if (!picture) return;
  addSkyPicture([at = *picture](const std::string& what) { return at.error(what); },
                file.locate(*picture, picture->text()), loads, scene);
}

}  // namespace saccade
