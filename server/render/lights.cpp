#include "render/lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace saccade {

Lights::Lights(const Scene& scene) {
  std::uint32_t geometry = 0;  // counted as EmbreeScene does
  for (const Mesh& mesh : scene.meshes) {
    const std::uint32_t id = geometry++;
    if (luminance(mesh.radiance) <= 0) continue;
    for (const auto& t : mesh.triangles) {
      const Vec3 a = mesh.positions[t[0]], e1 = mesh.positions[t[1]] - a, e2 = mesh.positions[t[2]] - a;
      add({a, e1, e2, 0, mesh.radiance, id}, length(cross(e1, e2)) / 2);
    }
  }
  for (const Sphere& sphere : scene.spheres) {
    const std::uint32_t id = geometry++;
    if (luminance(sphere.radiance) <= 0) continue;
    const float area = 4 * std::numbers::pi_v<float> * sphere.radius * sphere.radius;
    add({sphere.center, {}, {}, sphere.radius, sphere.radiance, id}, area);
  }
  if (empty()) return;
  const float power = cdf_.back();
  for (float& c : cdf_) c /= power;
  inv_power_ = 1 / power;
}

void Lights::add(const Light& light, float area) {
  if (area <= 0) return;
  lights_.push_back(light);
  cdf_.push_back((cdf_.empty() ? 0 : cdf_.back()) + luminance(light.radiance) * area);
}

LightSample Lights::sample(Lane u_light, Lane u1, Lane u2) const {
  const auto i = std::min<std::size_t>(std::upper_bound(cdf_.begin(), cdf_.end(), u_light) - cdf_.begin(),
                                       lights_.size() - 1);
  const Light& light = lights_[i];
  if (light.radius > 0) {
    const float z = 1 - 2 * u1, r = std::sqrt(std::max(0.f, 1 - z * z)),
                phi = 2 * std::numbers::pi_v<float> * u2;
    const Vec3 n{r * std::cos(phi), r * std::sin(phi), z};
    return {light.corner + n * light.radius, n, light.radiance, pdf(light.radiance), light.geometry};
  }
  // Uniform on the triangle by the square-root map.
  const float s = std::sqrt(u1);
  const Vec3 point = light.corner + light.edge1 * (1 - s) + light.edge2 * (u2 * s);
  return {point, normalize(cross(light.edge1, light.edge2)), light.radiance, pdf(light.radiance),
          light.geometry};
}

}  // namespace saccade
