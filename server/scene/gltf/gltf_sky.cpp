#include "scene/gltf/gltf_sky.h"

#include "scene/gltf/gltf_lights.h"

namespace saccade {
namespace {

std::optional<JsonNode> skyOf(const JsonNode& root) {
  const std::size_t scenes = root.count("scenes");
  if (scenes == 0) return {};
  return root.entry("scenes", root.index("scene", scenes).value_or(0)).extension("SACCADE_sky");
}

Affine turnOf(const JsonNode& sky) {
  const auto [x, y, z, w] = sky.numbers<4>("rotation", {0, 0, 0, 1});
  if (!isRotation({x, y, z, w})) throw sky.error("the rotation has no length");
  const Quaternion q = normalize(Quaternion{x, y, z, w});
  return {rotate(q, {1, 0, 0}), rotate(q, {0, 1, 0}), rotate(q, {0, 0, 1}), {}};
}

}  // namespace

void addSky(const GltfFile& file, FileLoads& loads, Scene& scene) {
  const auto sky = skyOf(file.root());
  if (!sky) return;
  const auto [r, g, b] = sky->numbers<3>("radiance", {1, 1, 1});
  scene.environment = Environment{checkedLight(*sky, {r, g, b}), {}, turnOf(*sky)};
  const auto picture = sky->find("picture");
  if (!picture) return;
  loads.add([at = *picture](const std::string& what) { return at.error(what); },
            [&loads, &scene, path = file.locate(*picture, picture->text())] {
              loads.takePixels(countPixels(path));
              scene.environment->picture = loadPicture(path, PixelUse::kRadiance);
            });
}

}  // namespace saccade
