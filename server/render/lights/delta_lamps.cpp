#include "render/lights/delta_lamps.h"

#include <cmath>
#include <limits>

namespace saccade {

IncidentLight DeltaLamps::at(std::size_t lamp, Vec3 point) const {
  if (lamp >= points_.size()) {
    const DirectionalLight& sun = suns_[lamp - points_.size()];
    constexpr float kEndless = std::numeric_limits<float>::infinity();
    return {-sun.direction, -sun.direction, kEndless, sun.irradiance, 1, true};
  }
  const PointLight& lit = points_[lamp];
  const Vec3 segment = lit.position - point;
  const float distance2 = dot(segment, segment);
  return {segment / std::sqrt(distance2), segment, kShadowEnd, lit.intensity / distance2, 1, true};
}

}  // namespace saccade
