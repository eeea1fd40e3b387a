#include "render/world/texture_color.h"

#include "render/world/surface_at.h"

namespace saccade {

Rgb textureColor(const PosedScene& posed, const Hit& hit, float cosine, float footprint) {
  const Scene& scene = posed.still().description();
  const HitShape shape(posed, hit);
  const Material& material = scene.materials[static_cast<std::size_t>(shape.material())];
  const TexturePatch texture = shape.mesh ? texturePatchAt(*shape.mesh, shape.mesh->uvs, hit)
                                          : texturePatchAt(*shape.sphere, normalize(hit.normal));
  return lookUp(scene, material.reflectance, texturePoint(texture, cosine, footprint));
}

}  // namespace saccade
