#include "render/lights/lamp_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/lights/sphere_cone.h"

namespace saccade {
namespace {

// Uniform on a convex polygon: a fan of triangles by their areas, then the square-root map.
Vec3 pointOn(const AnalyticLight::Side& side, float u1, float u2) {
  const Vec3 a = side.corners[0];
  float left = u1 * side.area;
  for (std::size_t k = 1;; ++k) {
    const Vec3 e1 = side.corners[k] - a, e2 = side.corners[k + 1] - a;
    const float area = length(cross(e1, e2)) / 2;
    if (left >= area && k + 2 < side.corners.size()) {
      left -= area;
      continue;
    }
    const float s = std::sqrt(std::min(left / area, 1.f));
    return a + e1 * (s * (1 - u2)) + e2 * (s * u2);
  }
}

// A place on a sphere, uniform in what the point sees of it.
LampPoints::Point pointOn(const AnalyticLight::Side& sphere, const LitPoint& from, float form_factor,
                          float u1, float u2) {
  const SphereCone cone(from.point, sphere.corners[0], sphere.radius);
  const auto [w, distance] = cone.at(u1, u2);
  const Vec3 position = from.point + w * distance;
  const float arriving = dot(w, from.normal);
  if (!(arriving > 0 && dot(w, from.geometric_normal) > 0)) return {position, 0};
  return {position, arriving * cone.solidAngle() * std::numbers::inv_pi_v<float> / form_factor};
}

}  // namespace

LampPoints::LampPoints(const AnalyticLight& light, const LitPoint& from, Rgb reflectance,
                       const EmitterStrengths& strengths)
    : from_(from) {
  int count = 0;
  for (const AnalyticLight::Side& side : light.sides()) {
    const float form_factor = AnalyticLight::formFactor(side, from);
    const float reflected = form_factor * luminance(reflectance * side.radiance) * strengths[side.geometry];
    if (reflected > 0) seen_[count++] = {&side, form_factor, unoccluded_[side.group] += reflected};
    ends_[side.group + 1] = count;
  }
}

LampPoints::Point LampPoints::at(int group, float u, float u1, float u2) const {
  const int end = ends_[group + 1];
  int i = ends_[group];
  while (i + 1 < end && u * unoccluded_[group] >= seen_[i].sum) ++i;
  const AnalyticLight::Side& side = *seen_[i].side;
  if (side.radius > 0) return pointOn(side, from_, seen_[i].form_factor, u1, u2);
  const Vec3 point = pointOn(side, u1, u2), segment = point - from_.point;
  const float leaving = -dot(segment, side.normal), arriving = dot(segment, from_.normal);
  if (!(leaving > 0 && arriving > 0 && dot(segment, from_.geometric_normal) > 0)) return {point, 0};
  const float distance2 = dot(segment, segment);
  const float factor = leaving * arriving * side.area * std::numbers::inv_pi_v<float>;
  return {point, factor / (distance2 * distance2 * seen_[i].form_factor)};
}

}  // namespace saccade
