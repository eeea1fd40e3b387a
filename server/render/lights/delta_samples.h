// Samples of lamps without extent.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "render/lights/incident_light.h"
#include "scene/scene.h"

namespace saccade {

// The points and spots of a scene. A point is a spot that shines everywhere.
inline std::vector<SpotLight> spotsOf(const Scene& scene) {
  constexpr float kAll = std::numbers::pi_v<float>;
  std::vector<SpotLight> spots;
  for (const PointLight& point : scene.point_lights)
    spots.push_back({point.position, {0, 0, 1}, point.intensity, kAll, kAll});
  spots.insert(spots.end(), scene.spot_lights.begin(), scene.spot_lights.end());
  return spots;
}

// `pdf`: the probability of the lamp.
inline IncidentLight sampleOf(const SpotLight& spot, Vec3 point, float pdf) {
  const Vec3 segment = spot.position - point;
  const float distance2 = dot(segment, segment);
  const Vec3 w = segment / std::sqrt(distance2);
  const bool everywhere = spot.beam >= std::numbers::pi_v<float>;
  const Rgb intensity = everywhere ? spot.intensity : intensityTowards(spot, -w);
  return {w, segment, kShadowEnd, intensity / distance2, pdf, true};
}
inline IncidentLight sampleOf(const DirectionalLight& sun, float pdf) {
  constexpr float kEndless = std::numeric_limits<float>::infinity();
  return {-sun.direction, -sun.direction, kEndless, sun.irradiance, pdf, true};
}

}  // namespace saccade
