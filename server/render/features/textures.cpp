#include "render/features/features.h"

namespace saccade {

Rgb meanOf(const Scene& scene, const SurfaceColor& c) {
  if (c.kind == SurfaceColor::Kind::kBitmap)
    return scene.textures[static_cast<std::size_t>(c.texture)].mean();
  return isTextured(c) ? (c.color0 + c.color1) / 2.f : c.color0;
}

bool hasTextures(const Scene& scene) {
  return anyMaterial(scene, [](const Material& m) {
    return isTextured(m.reflectance) || isTextured(m.specular) || isTextured(m.transmittance) ||
           isTextured(m.metallic_roughness) || isTextured(m.emission);
  });
}

void leaveOutTextures(Scene& scene) {
  for (Material& m : scene.materials)
    for (SurfaceColor* c :
         {&m.reflectance, &m.specular, &m.transmittance, &m.metallic_roughness, &m.emission})
      *c = constantColor(meanOf(scene, *c));
}

bool hasMips(const Scene& scene) {
  return std::any_of(scene.textures.begin(), scene.textures.end(),
                     [](const Texture& t) { return t.mipMapped(); });
}

void leaveOutMips(Scene& scene) {
  for (Texture& t : scene.textures) t.dropMips();
}

}  // namespace saccade
