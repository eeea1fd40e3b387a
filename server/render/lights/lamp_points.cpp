#include "render/lights/lamp_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace saccade {

LampPoints::LampPoints(const AnalyticLight& light, const LitPoint& from, Rgb reflectance,
                       const EmitterStrengths& strengths)
    : from_(from) {
  float sum = 0;
  for (const AnalyticLight::Side& side : light.sides()) {
    const float factor = AnalyticLight::formFactor(side, from);
    const float light_here = factor * luminance(reflectance * side.radiance) * strengths[side.geometry];
    if (!(light_here > 0)) continue;
    sides_[count_] = &side, factors_[count_] = factor;
    sums_[count_++] = sum += light_here;
  }
}

LampPoints::Point LampPoints::at(float u, float u1, float u2) const {
  int i = 0;
  while (i + 1 < count_ && u * sums_[count_ - 1] >= sums_[i]) ++i;
  const AnalyticLight::Side& side = *sides_[i];
  // A fan of triangles, each by its share of the area, and the square-root map.
  const Vec3 a = side.corners[0];
  std::size_t k = 1;
  float left = u1 * side.area, part = 0;
  for (;; ++k) {
    part = length(cross(side.corners[k] - a, side.corners[k + 1] - a)) / 2;
    if (left < part || k + 2 >= side.corners.size()) break;
    left -= part;
  }
  const float s = std::sqrt(std::min(left / part, 1.f));
  const Vec3 point = a + (side.corners[k] - a) * (s * (1 - u2)) + (side.corners[k + 1] - a) * (s * u2);
  const Vec3 segment = point - from_.point;
  const float distance2 = dot(segment, segment);
  const float leaving = -dot(segment, side.normal), arriving = dot(segment, from_.normal);
  if (!(leaving > 0 && arriving > 0 && dot(segment, from_.geometric_normal) > 0)) return {point, 0};
  const float factor = leaving * arriving * side.area * std::numbers::inv_pi_v<float> / (distance2 * distance2);
  return {point, factor / factors_[i]};
}

}  // namespace saccade
