#include "render/analytic_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace saccade {
namespace {

constexpr std::size_t kMaxSides = 16;  // more cost more than their shadows tell
constexpr std::size_t kMaxCorners = 8;

struct Polygon {
  std::array<Vec3, kMaxCorners> corners;
  std::size_t count = 0;
  void add(Vec3 v) {
    if (count < kMaxCorners) corners[count++] = v;
  }
};

// The part of a polygon, seen from the origin, that is above the plane with normal n.
Polygon above(const Polygon& in, Vec3 n) {
  Polygon out;
  for (std::size_t i = 0; i < in.count; ++i) {
    const Vec3 a = in.corners[i], b = in.corners[(i + 1) % in.count];
    const float height_a = dot(a, n), height_b = dot(b, n);
    if (height_a > 0) out.add(a);
    if ((height_a > 0) != (height_b > 0)) out.add(a + (b - a) * (height_a / (height_a - height_b)));
  }
  return out;
}

// Share of the cosine-weighted hemisphere about n that a polygon above the horizon covers [Lambert 1760].
float formFactor(const Polygon& polygon, Vec3 n) {
  float sum = 0;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Vec3 a = polygon.corners[i], b = polygon.corners[(i + 1) % polygon.count], edge = cross(a, b);
    const float sine = length(edge);
    if (sine > 0) sum += std::atan2(sine, dot(a, b)) * dot(n, edge) / sine;
  }
  return std::abs(sum) * (0.5f * std::numbers::inv_pi_v<float>);
}

}  // namespace

AnalyticLight::AnalyticLight(const Scene& scene)
    : held_(scene.meshes.size()),
      point_lights_(scene.point_lights),
      directional_lights_(scene.directional_lights) {
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const Mesh& mesh = scene.meshes[i];
    if (luminance(mesh.radiance) > 0 && sides_.size() + mesh.triangles.size() <= kMaxSides)
      addSides(mesh, static_cast<std::uint32_t>(i));
  }
}

void AnalyticLight::addSides(const Mesh& mesh, std::uint32_t geometry) {
  held_[geometry] = true;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = mesh.triangles[i];
    Side side{{mesh.positions[a], mesh.positions[b], mesh.positions[c]}, {}, mesh.radiance, geometry};
    const Vec3 normal = cross(side.corners[1] - side.corners[0], side.corners[2] - side.corners[0]);
    if (dot(normal, normal) == 0) continue;
    side.normal = normalize(normal);
    sides_.push_back(std::move(side));
  }
}

Rgb AnalyticLight::at(Vec3 point, Vec3 normal, Vec3 geometric_normal,
                      const EmitterStrengths& strengths) const {
  Rgb sum;
  for (const Side& side : sides_) {
    if (dot(point - side.corners[0], side.normal) <= 0) continue;
    Polygon seen;
    for (const Vec3 corner : side.corners) seen.add(corner - point);
    seen = above(seen, normal);
    if (!(normal == geometric_normal)) seen = above(seen, geometric_normal);
    sum = sum + side.radiance * (formFactor(seen, normal) * strengths[side.geometry]);
  }
  const auto addFrom = [&](Vec3 w, Rgb irradiance) {
    if (dot(w, geometric_normal) <= 0) return;
    sum = sum + irradiance * (std::max(0.f, dot(w, normal)) * std::numbers::inv_pi_v<float>);
  };
  for (const PointLight& l : point_lights_) {
    const Vec3 segment = l.position - point;
    const float distance2 = dot(segment, segment);
    addFrom(segment / std::sqrt(distance2), l.intensity / distance2);
  }
  for (const DirectionalLight& l : directional_lights_) addFrom(-l.direction, l.irradiance);
  return sum;
}

}  // namespace saccade
