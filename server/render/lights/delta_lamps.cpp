#include "render/lights/delta_lamps.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace saccade {

DeltaLamps::DeltaLamps(const Scene& scene) : suns_(scene.directional_lights) {
  constexpr float kAll = std::numbers::pi_v<float>;
  for (const PointLight& point : scene.point_lights)
    spots_.push_back({point.position, {0, 0, 1}, point.intensity, kAll, kAll});
  spots_.insert(spots_.end(), scene.spot_lights.begin(), scene.spot_lights.end());
}

IncidentLight DeltaLamps::at(std::size_t lamp, Vec3 point) const {
  if (lamp >= spots_.size()) {
    const DirectionalLight& sun = suns_[lamp - spots_.size()];
    constexpr float kEndless = std::numeric_limits<float>::infinity();
    return {-sun.direction, -sun.direction, kEndless, sun.irradiance, 1, true};
  }
  const SpotLight& spot = spots_[lamp];
  const Vec3 segment = spot.position - point;
  const float distance2 = dot(segment, segment);
  const Vec3 w = segment / std::sqrt(distance2);
  return {w, segment, kShadowEnd, intensityTowards(spot, -w) / distance2, 1, true};
}

}  // namespace saccade
