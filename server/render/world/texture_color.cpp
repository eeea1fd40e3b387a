#include "render/world/texture_color.h"

#include "render/world/surface_at.h"

namespace saccade {

Rgb textureColor(const Scene& scene, const Hit& hit, float cosine, float footprint) {
  const auto [mesh, sphere] = HitShape(scene, hit);
  const Material& material = scene.materials[mesh ? mesh->material : sphere->material];
  const TexturePatch texture =
      mesh ? texturePatchAt(*mesh, hit) : texturePatchAt(*sphere, normalize(hit.normal));
  return lookUp(scene, material.reflectance, texturePoint(texture, cosine, footprint));
}

}  // namespace saccade
