// The surface at a hit.
#pragma once

#include "render/bump.h"
#include "render/render_scene.h"

namespace saccade {

template <Shading S>
Rgb colorAt(const Scene& scene, const SurfaceColor& c, TexturePoint at) {
  if constexpr (!S.textures) return c.color0;
  return lookUp(scene, c, at);
}

template <Shading S>
Bsdf bsdfAt(const Scene& scene, const Material& m, TexturePoint at) {
  Bsdf b{nullptr, colorAt<S>(scene, m.reflectance, at)};
  if constexpr (!S.diffuseOnly()) b.specular = colorAt<S>(scene, m.specular, at);
  if constexpr (S.has(&BsdfTraits::transmits)) b.transmittance = colorAt<S>(scene, m.transmittance, at);
  return b;
}

// `footprint` is the width of the region that one path stands for, at a right angle to the ray, in scene
// units. S must cover scene.shading().
template <Shading S>
Surface surfaceAt(const RenderScene& render_scene, const Ray& ray, const Hit& hit, float footprint) {
  const Scene& scene = render_scene.description();
  const Vec3 n = normalize(hit.normal);
  const float cosine = -dot(n, ray.direction) / length(ray.direction);
  const bool front = cosine > 0;

  const Mesh* mesh = hit.geometry < scene.meshes.size() ? &scene.meshes[hit.geometry] : nullptr;
  const Sphere* sphere = mesh ? nullptr : &scene.spheres[hit.geometry - scene.meshes.size()];
  const int id = mesh ? mesh->material : sphere->material;
  const Material& material = scene.materials[id];
  const Patch patch = mesh ? patchAt(*mesh, hit, n) : patchAt(*sphere, n);
  TexturePatch texture;
  float across = 0;
  if (S.diffuseOnly() ? S.textures && isTextured(material.reflectance) : isTextured(material)) {
    texture = mesh ? texturePatchAt(*mesh, hit) : texturePatchAt(*sphere, n);
    across = footprint / std::max(std::abs(cosine), 0.05f);  // grazing: blur along both axes
  }
  const TexturePoint at{texture.uv, across * texture.uv_per_length};

  Vec3 ns = patch.shading_normal;
  const Rgb radiance = mesh ? mesh->radiance : sphere->radiance;
  Surface s{patch.point, n, ns, bsdfAt<S>(scene, material, at), front ? radiance : Rgb{}, false, 1};
  bool black = !front && !material.twosided;
  if constexpr (S.has(&BsdfTraits::transmits)) {
    const bool transmits = traitsOf(material.model.kind).transmits;
    black = black && !transmits;
    s.inside = transmits && !front;
  }
  if constexpr (!S.diffuseOnly()) s.bsdf.tables = &render_scene.tables(id);
  if constexpr (S.extras) {
    s.opacity = luminance(lookUp(scene, material.opacity, at));
    if (isBumpy(material)) ns = bumpedNormal(scene, material, ns, texture, at.footprint);
  }
  if (!front) s.geometric_normal = -n;
  s.shading_normal = dot(ns, s.geometric_normal) < 0 ? -ns : ns;
  if (black) s.bsdf.diffuse = s.bsdf.specular = {};
  return s;
}

}  // namespace saccade
