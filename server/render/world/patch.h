// The position of a hit within its shape, in space and in texture space.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/world/embree_scene.h"

namespace saccade {

struct Patch {
  Vec3 point;
  Vec3 shading_normal;  // unit, on either side
  float offset;         // see ray_offset.h
};

struct TexturePatch {
  Vec2 uv = {};
  float uv_per_length = 0;      // texture units per scene unit
  Vec3 dp_du = {}, dp_dv = {};  // change of place with uv; 0: unknown
};

template <class V>
V interpolate(const V& a, const V& b, const V& c, float u, float v) {
  return a * (1 - u - v) + b * u + c * v;
}

// Unit, on either side. `n` is the unit geometric normal.
inline Vec3 shadingNormalAt(const Mesh& mesh, const ShapePoint& at, Vec3 n) {
  if (mesh.normals.empty()) return n;
  const auto [i, j, k] = mesh.triangles[at.primitive];
  const Vec3 ns = interpolate(mesh.normals[i], mesh.normals[j], mesh.normals[k], at.u, at.v);
  return dot(ns, ns) > 0 ? normalize(ns) : n;
}

// `uvs`: a set of coordinates of the mesh.
inline TexturePatch texturePatchAt(const Mesh& mesh, const std::vector<Vec2>& uvs, const ShapePoint& at) {
  if (uvs.empty()) return {};
  const auto [i, j, k] = mesh.triangles[at.primitive];
  const Vec3 ab = mesh.positions[j] - mesh.positions[i], ac = mesh.positions[k] - mesh.positions[i];
  const Vec2 p = uvs[i], q = uvs[j], r = uvs[k];
  const Vec2 pq{q.x - p.x, q.y - p.y}, pr{r.x - p.x, r.y - p.y};
  const float uv_area = pq.x * pr.y - pr.x * pq.y;
  TexturePatch patch{{p.x + pq.x * at.u + pr.x * at.v, p.y + pq.y * at.u + pr.y * at.v},
                     std::sqrt(std::abs(uv_area) / std::max(length(cross(ab, ac)), 1e-20f))};
  if (uv_area != 0) {
    patch.dp_du = (ab * pr.y - ac * pq.y) / uv_area;
    patch.dp_dv = (ac * pq.x - ab * pr.x) / uv_area;
  }
  return patch;
}
inline TexturePatch texturePatchAt(const Sphere& sphere, Vec3 n) {
  constexpr float kPi = std::numbers::pi_v<float>;
  const float azimuth = std::atan2(n.y, n.x);
  const float sin_polar = std::max(std::sqrt(n.x * n.x + n.y * n.y), 1e-6f);
  return {
      {(azimuth < 0 ? azimuth + 2 * kPi : azimuth) / (2 * kPi), std::acos(std::clamp(n.z, -1.f, 1.f)) / kPi},
      1 / (2 * kPi * sphere.radius),
      Vec3{-n.y, n.x, 0} * (2 * kPi * sphere.radius),
      Vec3{n.x * n.z / sin_polar, n.y * n.z / sin_polar, -sin_polar} * (kPi * sphere.radius)};
}

}  // namespace saccade
