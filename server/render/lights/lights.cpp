#include "render/lights/lights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace saccade {
namespace {

constexpr float kEndless = std::numeric_limits<float>::infinity();

IncidentLight distant(Vec3 direction, Rgb radiance, float pdf, bool delta) {
  return {direction, direction, kEndless, radiance, pdf, delta};
}

}  // namespace

Lights::Lights(const Scene& scene, float radius)
    : point_lights_(scene.point_lights), directional_lights_(scene.directional_lights) {
  // Power over pi. Distant lights count the power that falls on the disk of the scene.
  const float disk = std::numbers::pi_v<float> * radius * radius;
  addAreaLights(scene);
  for (const PointLight& l : point_lights_) choose(4 * luminance(l.intensity));
  for (const DirectionalLight& l : directional_lights_)
    choose(luminance(l.irradiance) * disk * std::numbers::inv_pi_v<float>);
  if (scene.environment) {
    environment_.emplace(*scene.environment);
    choose(4 * environment_->meanLuminance() * disk);
  }
  if (empty()) return;
  const float power = cdf_.back();
  for (float& c : cdf_) c /= power;
  inv_power_ = 1 / power;
}

void Lights::addAreaLights(const Scene& scene) {
  std::uint32_t geometry = 0;  // counted as EmbreeScene does
  for (const Mesh& mesh : scene.meshes) {
    const std::uint32_t id = geometry++;
    if (!emits(mesh)) continue;
    for (const auto& t : mesh.triangles) {
      const Vec3 a = mesh.positions[t[0]], e1 = mesh.positions[t[1]] - a, e2 = mesh.positions[t[2]] - a;
      add({a, e1, e2, 0, mesh.radiance, id}, length(cross(e1, e2)) / 2);
    }
  }
  for (const Sphere& sphere : scene.spheres) {
    const std::uint32_t id = geometry++;
    if (!emits(sphere)) continue;
    const float area = 4 * std::numbers::pi_v<float> * sphere.radius * sphere.radius;
    add({sphere.center, {}, {}, sphere.radius, sphere.radiance, id}, area);
  }
}

void Lights::add(const AreaLight& light, float area) {
  if (area <= 0) return;
  area_lights_.push_back(light);
  choose(luminance(light.radiance) * area);
}

void Lights::choose(float power) {
  cdf_.push_back((empty() ? 0 : cdf_.back()) + power);
}

IncidentLight Lights::at(Vec3 point, float u_light, float u1, float u2) const {
  const auto i = std::min<std::size_t>(std::upper_bound(cdf_.begin(), cdf_.end(), u_light) - cdf_.begin(),
                                       cdf_.size() - 1);
  if (i < area_lights_.size()) return areaLight(area_lights_[i], point, u1, u2);
  return otherLight(i, point, u1, u2);
}

IncidentLight Lights::areaLight(const AreaLight& light, Vec3 point, float u1, float u2) const {
  Vec3 on_light, normal;
  if (light.radius > 0) {
    const float z = 1 - 2 * u1, r = std::sqrt(std::max(0.f, 1 - z * z)),
                phi = 2 * std::numbers::pi_v<float> * u2;
    normal = {r * std::cos(phi), r * std::sin(phi), z};
    on_light = light.corner + normal * light.radius;
  } else {  // uniform on the triangle by the square-root map
    const float s = std::sqrt(u1);
    on_light = light.corner + light.edge1 * (1 - s) + light.edge2 * (u2 * s);
    normal = normalize(cross(light.edge1, light.edge2));
  }
  const Vec3 segment = on_light - point;
  const float distance2 = dot(segment, segment);
  const Vec3 w = segment / std::sqrt(distance2);
  const float cosine = -dot(w, normal);
  const float per_solid_angle = cosine > 0 ? pdf(light.radiance) * distance2 / cosine : 0;
  return {w, segment, kShadowEnd, light.radiance, per_solid_angle, false, light.geometry};
}

IncidentLight Lights::otherLight(std::size_t i, Vec3 point, float u1, float u2) const {
  const float p = probability(i);
  i -= area_lights_.size();
  if (i < point_lights_.size()) {
    const PointLight& l = point_lights_[i];
    const Vec3 segment = l.position - point;
    const float distance2 = dot(segment, segment);
    return {segment / std::sqrt(distance2), segment, kShadowEnd, l.intensity / distance2, p, true};
  }
  i -= point_lights_.size();
  if (i < directional_lights_.size())
    return distant(-directional_lights_[i].direction, directional_lights_[i].irradiance, p, true);
  const EnvironmentSample s = environment_->sample(u1, u2);
  return distant(s.direction, s.radiance, s.pdf * p, false);
}

Rgb Lights::distantRadiance(Vec3 direction) const {
  return environment_ ? environment_->radiance(direction) : Rgb{};
}

float Lights::distantPdf(Vec3 direction) const {
  return environment_ ? environment_->pdf(direction) * probability(cdf_.size() - 1) : 0;
}

}  // namespace saccade
