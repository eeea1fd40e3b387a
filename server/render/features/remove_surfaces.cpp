#include "render/features/features.h"

namespace saccade {
namespace {

template <class Shape>
void eraseDark(std::vector<Shape>& shapes, const std::vector<bool>& gone) {
  std::erase_if(shapes, [&](const Shape& s) {
    return gone[static_cast<std::size_t>(s.material)] && s.radiance == Rgb{};
  });
}

}  // namespace

void removeSurfaces(Scene& scene, const std::vector<bool>& gone) {
  eraseDark(scene.meshes, gone);
  eraseDark(scene.spheres, gone);
  for (std::size_t i = 0; i < gone.size(); ++i) {
    if (!gone[i]) continue;
    const bool twosided = scene.materials[i].twosided;
    scene.materials[i] = {.name = scene.materials[i].name,
                          .reflectance = {},
                          .twosided = twosided,
                          .emission = scene.materials[i].emission};
  }
}

}  // namespace saccade
