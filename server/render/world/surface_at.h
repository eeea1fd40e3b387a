// The surface at a hit.
#pragma once

#include "render/world/bump.h"
#include "render/world/posed_scene.h"
#include "render/world/ray_offset.h"

namespace saccade {

// A point in both sets of texture coordinates.
struct TexturePoints {
  TexturePoint first, second;

  TexturePoint of(const SurfaceColor& c) const { return c.second_uvs ? second : first; }
};

template <Shading S>
inline constexpr bool kMetallicRoughness = (S.kinds & only(BsdfKind::kMetallicRoughness)) != 0;

// Colours of other kinds than metallic-roughness have the first set.
template <Shading S>
Rgb colorAt(const Scene& scene, const SurfaceColor& c, const TexturePoints& at) {
  if constexpr (!S.textures) return c.color0;
  return lookUp(scene, c, kMetallicRoughness<S> ? at.of(c) : at.first);
}

// `footprint`: at a right angle to a ray that makes an angle of this cosine with the surface.
inline TexturePoint texturePoint(const TexturePatch& patch, float cosine, float footprint) {
  const float across = footprint / std::max(std::abs(cosine), 0.05f);  // grazing: blur along both axes
  return {patch.uv, across * patch.uv_per_length};
}

// The shape that a hit lies on: one of both is nullptr.
struct HitShape {
  HitShape(const PosedScene& posed, const Hit& hit) : HitShape(posed, posed.still().description(), hit) {}

  int material() const { return mesh ? mesh->material : sphere->material; }
  Rgb radiance() const { return mesh ? mesh->radiance : sphere->radiance; }

  const Mesh* mesh;  // in the form that it has
  const Sphere* sphere;

 private:
  HitShape(const PosedScene& posed, const Scene& scene, const Hit& hit)
      : mesh(hit.geometry < scene.meshes.size() ? &posed.mesh(hit.geometry) : nullptr),
        sphere(mesh ? nullptr : &scene.spheres[hit.geometry - scene.meshes.size()]) {}
};

// The colour that the vertices of a shape give its base.
template <Shading S>
Rgb vertexColor(const HitShape& shape, const ShapePoint& on) {
  if constexpr (kMetallicRoughness<S>) {
    if (!shape.mesh || shape.mesh->colors.empty()) return {1, 1, 1};
    const auto [i, j, k] = shape.mesh->triangles[on.primitive];
    const std::vector<Rgb>& colors = shape.mesh->colors;
    return interpolate(colors[i], colors[j], colors[k], on.u, on.v);
  }
  return {1, 1, 1};
}

// `tables`: of the material; nullptr for kernels of diffuse surfaces alone. `factor`: see vertexColor().
template <Shading S>
Bsdf bsdfAt(const Scene& scene, const Material& m, const BsdfTables* tables, const TexturePoints& at,
            Rgb factor) {
  if constexpr (kMetallicRoughness<S>)
    if (m.model.kind == BsdfKind::kMetallicRoughness)
      return MetallicRoughness::at(*tables, colorAt<S>(scene, m.reflectance, at) * factor,
                                   colorAt<S>(scene, m.metallic_roughness, at));
  Bsdf b{tables, colorAt<S>(scene, m.reflectance, at)};
  if constexpr (!S.diffuseOnly()) b.specular = colorAt<S>(scene, m.specular, at);
  if constexpr (S.has(&BsdfTraits::transmits)) b.transmittance = colorAt<S>(scene, m.transmittance, at);
  return b;
}

// In scene axes. `n` is the unit geometric normal. `uvs`: of the set of coordinates, where the shape is a
// mesh.
inline TexturePatch texturePatchOf(const PosedScene& posed, const Hit& hit, Vec3 n,
                                   std::vector<Vec2> Mesh::*uvs) {
  const HitShape shape(posed, hit);
  if (hit.body == kNoBody)
    return shape.mesh ? texturePatchAt(*shape.mesh, shape.mesh->*uvs, hit) : texturePatchAt(*shape.sphere, n);
  const RigidMotion& motion = posed.bodies()->motions()[hit.body];
  TexturePatch patch = shape.mesh ? texturePatchAt(*shape.mesh, shape.mesh->*uvs, hit)
                                  : texturePatchAt(*shape.sphere, motion.restDirection(n));
  patch.dp_du = motion.direction(patch.dp_du), patch.dp_dv = motion.direction(patch.dp_dv);
  return patch;
}

// `n` is the unit geometric normal as wound, and `cosine` that between it and the ray's reverse. `footprint`
// is the width of the region that one path stands for, at a right angle to the ray, in scene units. S must
// cover the shading of the scene.
template <Shading S>
Surface surfaceOf(const PosedScene& posed, const Hit& hit, const Patch& patch, Vec3 n, float cosine,
                  float footprint) {
  const Scene& scene = posed.still().description();
  const bool front = cosine > 0;
  const HitShape shape(posed, hit);
  const int id = shape.material();
  const Material& material = scene.materials[id];
  TexturePatch texture, second;
  if (S.diffuseOnly() ? S.textures && isTextured(material.reflectance) : isTextured(material))
    texture = texturePatchOf(posed, hit, n, &Mesh::uvs);
  if constexpr (S.extras)
    if (shape.mesh && !shape.mesh->second_uvs.empty())
      second = texturePatchOf(posed, hit, n, &Mesh::second_uvs);
  const TexturePoints at{texturePoint(texture, cosine, footprint), texturePoint(second, cosine, footprint)};

  Vec3 ns = patch.shading_normal;
  const Rgb radiance = shape.radiance();
  const BsdfTables* tables = S.diffuseOnly() ? nullptr : &posed.still().tables(id);
  Surface s{patch.point,
            patch.offset,
            n,
            ns,
            bsdfAt<S>(scene, material, tables, at, vertexColor<S>(shape, hit)),
            front ? radiance : Rgb{},
            false,
            1};
  bool black = !front && !material.twosided;
  if constexpr (S.has(&BsdfTraits::transmits)) {
    const bool transmits = traitsOf(material.model.kind).transmits;
    black = black && !transmits;
    s.inside = transmits && !front;
  }
  if constexpr (S.extras) {
    s.opacity = luminance(lookUp(scene, material.opacity, at.of(material.opacity)));
    if (isTextured(material.emission))
      s.radiance = s.radiance * lookUp(scene, material.emission, at.of(material.emission));
    if (isBumpy(material))
      ns = bentNormal(scene, material, ns, material.normals.second_uvs ? second : texture,
                      at.of(material.normals).footprint);
  }
  if (!front) s.geometric_normal = -n;
  s.shading_normal = dot(ns, s.geometric_normal) < 0 ? -ns : ns;
  if (black) s.bsdf.diffuse = s.bsdf.specular = {};
  return s;
}

template <Shading S>
Surface surfaceAt(const PosedScene& scene, const Ray& ray, const Hit& hit, float footprint) {
  Vec3 n = normalize(hit.normal);
  const Mesh* mesh = HitShape(scene, hit).mesh;
  const Vec3 point = ray.origin + ray.direction * hit.t;
  Patch patch{point, mesh ? shadingNormalAt(*mesh, hit, n) : n,
              rayOffset(ray.origin, point, scene.shapeRows()[hit.geometry].edge)};
  if (hit.body != kNoBody) {
    const RigidMotion& motion = scene.bodies()->motions()[hit.body];
    n = motion.direction(n), patch.shading_normal = motion.direction(patch.shading_normal);
  }
  return surfaceOf<S>(scene, hit, patch, n, -dot(n, ray.direction) / length(ray.direction), footprint);
}

}  // namespace saccade
