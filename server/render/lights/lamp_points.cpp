#include "render/lights/lamp_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace saccade {
namespace {

// Uniform on a convex polygon: a fan of triangles by their areas, then the square-root map.
Vec3 pointOn(const Polygon& polygon, const std::array<float, Polygon::kMaxCorners>& areas, float u1,
             float u2) {
  std::size_t k = 2;
  const float area = u1 * areas[polygon.count - 1];
  while (k + 1 < polygon.count && area >= areas[k]) ++k;
  const float s = std::sqrt(std::min((area - areas[k - 1]) / (areas[k] - areas[k - 1]), 1.f));
  const Vec3 a = polygon.corners[0], b = polygon.corners[k - 1], c = polygon.corners[k];
  return a * (1 - s) + b * (s * (1 - u2)) + c * (s * u2);
}

}  // namespace

void LampPoints::lookFrom(const LitPoint& from, Rgb reflectance) {
  from_ = from, ends_ = {}, unoccluded_ = {};
  int count = 0;
  for (const AnalyticLight::Side& side : light_.sides()) {
    Seen& seen = seen_[count];
    seen.part = AnalyticLight::seen(side, from);
    const float form_factor = AnalyticLight::formFactor(seen.part, from);
    const float reflected = form_factor * luminance(reflectance * side.radiance) * strengths_[side.geometry];
    if (reflected > 0) {
      seen.normal = side.normal, seen.sum = unoccluded_[side.group] += reflected;
      measure(form_factor, seen), ++count;
    }
    ends_[side.group + 1] = count;
  }
}

void LampPoints::measure(float form_factor, Seen& seen) {
  const Polygon& part = seen.part;
  for (std::size_t k = 2; k < part.count; ++k) {
    const Vec3 a = part.corners[0];
    const float area = length(cross(part.corners[k - 1] - a, part.corners[k] - a)) / 2;
    seen.areas[k] = seen.areas[k - 1] + area;
  }
  seen.weight = seen.areas[part.count - 1] * std::numbers::inv_pi_v<float> / form_factor;
}

LampPoints::Point LampPoints::at(int group, float u, float u1, float u2) const {
  const int end = ends_[group + 1];
  int i = ends_[group];
  while (i + 1 < end && u * unoccluded_[group] >= seen_[i].sum) ++i;
  const Seen& seen = seen_[i];
  const Vec3 segment = pointOn(seen.part, seen.areas, u1, u2);
  const float leaving = -dot(segment, seen.normal), arriving = dot(segment, from_.normal);
  const float distance2 = dot(segment, segment);
  return {from_.point + segment,
          std::max(0.f, leaving) * std::max(0.f, arriving) * seen.weight / (distance2 * distance2)};
}

}  // namespace saccade
