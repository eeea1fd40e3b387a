#include "render/lights/lamps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace saccade {

float AreaLamp::area() const {
  return radius > 0 ? 4 * std::numbers::pi_v<float> * radius * radius : length(cross(edge1, edge2)) / 2;
}

Lamps::Lamps(const Scene& scene) : points_(scene.point_lights) {
  addAreaLamps(scene);
  std::vector<float> power;  // over pi
  for (const AreaLamp& lamp : area_lamps_) power.push_back(luminance(lamp.radiance) * lamp.area());
  choices_[1] = LightChoice(power);
  for (const PointLight& point : points_) power.push_back(4 * luminance(point.intensity));
  choices_[0] = LightChoice(power);
}

void Lamps::addAreaLamps(const Scene& scene) {
  std::uint32_t geometry = 0;  // counted as EmbreeScene does
  for (const Mesh& mesh : scene.meshes) {
    const std::uint32_t id = geometry++;
    if (!emits(mesh)) continue;
    for (const auto& t : mesh.triangles) {
      const Vec3 a = mesh.positions[t[0]];
      add({a, mesh.positions[t[1]] - a, mesh.positions[t[2]] - a, 0, mesh.radiance, id});
    }
  }
  for (const Sphere& sphere : scene.spheres) {
    const std::uint32_t id = geometry++;
    if (emits(sphere)) add({sphere.center, {}, {}, sphere.radius, sphere.radiance, id});
  }
}

void Lamps::add(const AreaLamp& lamp) {
  if (lamp.area() > 0) area_lamps_.push_back(lamp);
}

IncidentLight Lamps::sample(LightSet set, Vec3 point, float u_lamp, float u1, float u2) const {
  const std::size_t i = choice(set).choose(u_lamp);
  if (i < area_lamps_.size()) return ofArea(area_lamps_[i], pdf(set, area_lamps_[i].radiance), point, u1, u2);
  const PointLight& lamp = points_[i - area_lamps_.size()];
  const Vec3 segment = lamp.position - point;
  const float distance2 = dot(segment, segment);
  return {segment / std::sqrt(distance2), segment, kShadowEnd, lamp.intensity / distance2,
          choice(set).probability(i),     true};
}

// `pdf`: per area.
IncidentLight Lamps::ofArea(const AreaLamp& lamp, float pdf, Vec3 point, float u1, float u2) const {
  Vec3 on_lamp, normal;
  if (lamp.radius > 0) {
    const float z = 1 - 2 * u1, r = std::sqrt(std::max(0.f, 1 - z * z)),
                phi = 2 * std::numbers::pi_v<float> * u2;
    normal = {r * std::cos(phi), r * std::sin(phi), z};
    on_lamp = lamp.corner + normal * lamp.radius;
  } else {  // uniform on the triangle by the square-root map
    const float s = std::sqrt(u1);
    on_lamp = lamp.corner + lamp.edge1 * (1 - s) + lamp.edge2 * (u2 * s);
    normal = normalize(cross(lamp.edge1, lamp.edge2));
  }
  const Vec3 segment = on_lamp - point;
  const float distance2 = dot(segment, segment);
  const Vec3 w = segment / std::sqrt(distance2);
  const float cosine = -dot(w, normal);
  const float per_solid_angle = cosine > 0 ? pdf * distance2 / cosine : 0;
  return {w, segment, kShadowEnd, lamp.radiance, per_solid_angle, false, lamp.geometry};
}

}  // namespace saccade
