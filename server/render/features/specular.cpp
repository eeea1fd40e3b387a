#include <utility>

#include "render/bsdf/bsdf.h"
#include "render/features/features.h"

namespace saccade {
namespace {

bool isSpecular(const Material& m) {
  return m.model.kind != BsdfKind::kDiffuse;
}

// Applies change(colour) at each point of `c`. A changed bitmap becomes a new texture.
template <class Change>
SurfaceColor mapped(Scene& scene, SurfaceColor c, Change change) {
  c.color0 = change(c.color0), c.color1 = change(c.color1);
  if (c.kind != SurfaceColor::Kind::kBitmap) return c;
  const Texture& picture = scene.textures[static_cast<std::size_t>(c.texture)];
  std::vector<Rgb> pixels = picture.pixels();
  std::transform(pixels.begin(), pixels.end(), pixels.begin(), change);
  Texture all(picture.width(), picture.height(), std::move(pixels));
  all.setWrap(picture.wrapU(), picture.wrapV());
  c.texture = static_cast<int>(scene.textures.size());
  scene.textures.push_back(std::move(all));
  return c;
}

// The albedo of plastic or metal at a right angle, over the surface. If both its colours vary, the result has
// the colours of the base and the mean of the interface.
SurfaceColor albedoAcross(Scene& scene, const Material& m) {
  const BsdfTables tables(m.model);
  if (m.model.kind == BsdfKind::kMetallicRoughness)
    return mapped(scene, m.reflectance, [&, mean = meanOf(scene, m.metallic_roughness)](Rgb colour) {
      return bsdfAlbedo(MetallicRoughness::at(tables, colour, mean), 1);
    });
  Bsdf b{.tables = &tables, .diffuse = meanOf(scene, m.reflectance), .specular = meanOf(scene, m.specular)};
  const bool base = traitsOf(m.model.kind).base && (isTextured(m.reflectance) || !isTextured(m.specular));
  return mapped(scene, base ? m.reflectance : m.specular, [&](Rgb colour) {
    (base ? b.diffuse : b.specular) = colour;
    return bsdfAlbedo(b, 1);
  });
}

}  // namespace

bool hasSpecular(const Scene& scene) {
  return anyMaterial(scene, isSpecular);
}

// Glass is removed. It transmits nearly all light, and an opaque surface in its place would hide the scene
// behind it.
void leaveOutSpecular(Scene& scene) {
  std::vector<bool> glass;
  for (Material& m : scene.materials) {
    glass.push_back(traitsOf(m.model.kind).transmits);
    if (!isSpecular(m) || glass.back()) continue;
    m.reflectance = albedoAcross(scene, m);
    m.specular = kWhite;
    m.model = {};
  }
  removeSurfaces(scene, glass);
}

}  // namespace saccade
