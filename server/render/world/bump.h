// Bump maps, normals of the surface that a height over the mesh makes [Blinn 1978], and normal maps.
#pragma once

#include "render/surface/surface_color.h"
#include "render/world/patch.h"

namespace saccade {

// The unit normal n, bent by the bump map. Slopes are measured over the footprint, and at least over a texel.
inline Vec3 bumpedNormal(const Scene& scene, const Material& m, Vec3 n, const TexturePatch& patch,
                         float footprint) {
  const auto height = [&](Vec2 uv) {
    return luminance(lookUp(scene, m.height, {uv, footprint})) * m.height_scale;
  };
  float step = std::max(footprint, 1e-6f);
  if (m.height.kind == SurfaceColor::Kind::kBitmap) {
    const Texture& t = scene.textures[m.height.texture];
    const Vec2 direct = m.height.uv_scale, across = m.height.uv_cross;
    const float scale =
        std::max({std::abs(direct.x), std::abs(direct.y), std::abs(across.x), std::abs(across.y)});
    step = std::max(step, 1 / (static_cast<float>(std::max(t.width(), t.height())) * scale));
  }
  const auto [u, v] = patch.uv;
  const float dh_du = (height({u + step / 2, v}) - height({u - step / 2, v})) / step;
  const float dh_dv = (height({u, v + step / 2}) - height({u, v - step / 2})) / step;
  // Tangents of the displaced surface. The part of the patch's tangents along n is left out.
  const Vec3 du = patch.dp_du + n * (dh_du - dot(n, patch.dp_du));
  const Vec3 dv = patch.dp_dv + n * (dh_dv - dot(n, patch.dp_dv));
  const Vec3 bent = cross(du, dv);
  if (!(dot(bent, bent) > 0)) return n;
  return normalize(dot(bent, n) < 0 ? -bent : bent);
}

// The unit normal n, turned by the normal map. Its axes are the directions in which the coordinates of the
// picture grow, at a right angle to n [glTF 2.0, 3.9.3].
inline Vec3 mappedNormal(const Scene& scene, const Material& m, Vec3 n, const TexturePatch& patch,
                         float footprint) {
  const Vec3 local = lookUp(scene, m.normals, {patch.uv, footprint}) * 2.f - Vec3{1, 1, 1};
  // The columns of the inverse of the map from (u, v) to the picture, by the sign of its determinant alone.
  const Vec2 direct = m.normals.uv_scale, across = m.normals.uv_cross;
  const float side = std::copysign(1.f, direct.x * direct.y - across.x * across.y);
  const auto along = [&](float u, float v) {
    const Vec3 tangent = patch.dp_du * (side * u) + patch.dp_dv * (side * v);
    const Vec3 flat = tangent - n * dot(n, tangent);
    const float size = length(flat);
    return size > 0 ? flat * (1 / size) : Vec3{};
  };
  const Vec3 right = along(direct.y, -across.y), up = along(-across.x, direct.x);
  const Vec3 bent = (right * local.x + up * local.y) * m.normals_scale + n * std::max(local.z, 1e-3f);
  return normalize(bent);
}

// By the map that the material has.
inline Vec3 bentNormal(const Scene& scene, const Material& m, Vec3 n, const TexturePatch& patch,
                       float footprint) {
  return isTextured(m.normals) ? mappedNormal(scene, m, n, patch, footprint)
                               : bumpedNormal(scene, m, n, patch, footprint);
}

}  // namespace saccade
