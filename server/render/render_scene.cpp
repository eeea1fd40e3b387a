#include "render/render_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace saccade {
namespace {

constexpr float kRelativeEpsilon = 2e-5f;  // of the scene's diagonal: some hundred ulps of its coordinates

template <class V>
V interpolate(const V& a, const V& b, const V& c, float u, float v) {
  return a * (1 - u - v) + b * u + c * v;
}

// Mean over [x - w/2, x + w/2] of the square wave that is +1 on [0, 1/2) and -1 on [1/2, 1), repeated.
float filteredSquareWave(float x, float w) {
  const auto integral = [](float t) {
    const float f = t - std::floor(t);
    return std::min(f, 1 - f);
  };
  w = std::max(w, 1e-5f);
  return (integral(x + w / 2) - integral(x - w / 2)) / w;
}

}  // namespace

RenderScene::RenderScene(Scene scene)
    : scene_(std::move(scene)),
      geometry_(scene_),
      lights_(scene_),
      channels_(colorChannels(scene_)),
      epsilon_(kRelativeEpsilon * geometry_.diagonal()) {
  requireRenderable(scene_);
}

Surface RenderScene::surface(const Ray& ray, const Hit& hit, float footprint) const {
  Vec3 n = normalize(hit.normal);
  const float cosine = -dot(n, ray.direction) / length(ray.direction);
  const bool front = cosine > 0;
  const Patch patch = hit.geometry < scene_.meshes.size()
                          ? meshPatch(scene_.meshes[hit.geometry], hit, n)
                          : spherePatch(scene_.spheres[hit.geometry - scene_.meshes.size()], n);
  if (!front) n = -n;
  const Vec3 ns = dot(patch.shading_normal, n) < 0 ? -patch.shading_normal : patch.shading_normal;

  const Material& material = scene_.materials[patch.material];
  const float across = footprint / std::max(std::abs(cosine), 0.05f);  // grazing: blur along both axes
  const bool black = !front && !material.twosided;
  return {patch.point, n, ns,
          black ? Rgb{} : reflectance(material.reflectance, patch.uv, across * patch.uv_per_length),
          front ? patch.radiance : Rgb{}};
}

RenderScene::Patch RenderScene::meshPatch(const Mesh& mesh, const Hit& hit, Vec3 normal) const {
  const auto [i, j, k] = mesh.triangles[hit.primitive];
  const Vec3 a = mesh.positions[i], b = mesh.positions[j], c = mesh.positions[k];
  Patch patch{interpolate(a, b, c, hit.u, hit.v), normal, {}, 0, mesh.material, mesh.radiance};
  if (!mesh.normals.empty()) {
    const Vec3 ns = interpolate(mesh.normals[i], mesh.normals[j], mesh.normals[k], hit.u, hit.v);
    if (dot(ns, ns) > 0) patch.shading_normal = normalize(ns);
  }
  if (!mesh.uvs.empty() &&
      scene_.materials[mesh.material].reflectance.kind != SurfaceColor::Kind::kConstant) {
    const Vec2 p = mesh.uvs[i], q = mesh.uvs[j], r = mesh.uvs[k];
    patch.uv = {p.x * (1 - hit.u - hit.v) + q.x * hit.u + r.x * hit.v,
                p.y * (1 - hit.u - hit.v) + q.y * hit.u + r.y * hit.v};
    const float uv_area = std::abs((q.x - p.x) * (r.y - p.y) - (r.x - p.x) * (q.y - p.y));
    patch.uv_per_length = std::sqrt(uv_area / std::max(length(cross(b - a, c - a)), 1e-20f));
  }
  return patch;
}

RenderScene::Patch RenderScene::spherePatch(const Sphere& sphere, Vec3 normal) const {
  constexpr float kPi = std::numbers::pi_v<float>;
  const float azimuth = std::atan2(normal.y, normal.x);
  const Vec2 uv{(azimuth < 0 ? azimuth + 2 * kPi : azimuth) / (2 * kPi),
                std::acos(std::clamp(normal.z, -1.f, 1.f)) / kPi};
  return {sphere.center + normal * sphere.radius, normal,          uv,
          1 / (2 * kPi * sphere.radius),          sphere.material, sphere.radiance};
}

Rgb RenderScene::reflectance(const SurfaceColor& r, Vec2 uv, float footprint) const {
  if (r.kind == SurfaceColor::Kind::kConstant) return r.color0;
  const Vec2 st{uv.x * r.uv_scale.x + r.uv_offset.x, uv.y * r.uv_scale.y + r.uv_offset.y};
  const float width = footprint * std::sqrt(std::abs(r.uv_scale.x * r.uv_scale.y));
  if (r.kind == SurfaceColor::Kind::kBitmap) return scene_.textures[r.texture].sample(st, width);
  // Mitsuba's checkerboard has color0 where both coordinates lie in the same half of their period.
  const float same = 0.5f + 0.5f * filteredSquareWave(st.x, width) * filteredSquareWave(st.y, width);
  return r.color0 * same + r.color1 * (1 - same);
}

}  // namespace saccade
