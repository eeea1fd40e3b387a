#include "scene/scene.h"

#include <algorithm>

namespace saccade {
namespace {

bool grey(Rgb c) {
  return c.x == c.y && c.y == c.z;
}
bool grey(const Material& m) {
  return grey(m.reflectance.color0) && grey(m.reflectance.color1);
}

}  // namespace

int colorChannels(const Scene& scene) {
  const bool all_grey =
      std::all_of(scene.materials.begin(), scene.materials.end(),
                  [](const Material& m) { return grey(m); }) &&
      std::all_of(scene.textures.begin(), scene.textures.end(), [](const Texture& t) { return t.grey(); }) &&
      std::all_of(scene.meshes.begin(), scene.meshes.end(), [](const Mesh& m) { return grey(m.radiance); }) &&
      std::all_of(scene.spheres.begin(), scene.spheres.end(),
                  [](const Sphere& s) { return grey(s.radiance); });
  return all_grey ? 1 : 3;
}

}  // namespace saccade
