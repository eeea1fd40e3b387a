#include "render/lights/lamp_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/lights/sphere_cone.h"

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

// Uniform on a parallelogram. Unlike pointOn(), it keeps numbers along an edge evenly spaced.
Vec3 pointOnParallelogram(const Polygon& quad, float u1, float u2) {
  const Vec3 a = quad.corners[0];
  return a + (quad.corners[1] - a) * u1 + (quad.corners[3] - a) * u2;
}

bool isParallelogram(const Polygon& polygon) {
  constexpr float kRounding = 1e-5f;
  if (polygon.count != 4) return false;
  const auto& at = polygon.corners;
  return length((at[0] - at[1]) + (at[2] - at[3])) <= kRounding * length(at[2] - at[0]);
}

// A place on a disk, uniform by area.
LampPoints::Point pointOnDisk(const Disk& disk, const LitPoint& from, float form_factor, float u1, float u2) {
  const float r = disk.radius * std::sqrt(u1), turn = 2 * std::numbers::pi_v<float> * u2;
  const Vec3 position =
      disk.center + ShadingFrame<float>(disk.normal).toWorld({r * std::cos(turn), r * std::sin(turn), 0});
  const Vec3 segment = position - from.point;
  if (!(dot(segment, from.geometric_normal) > 0)) return {position, 0};
  const float area_over_pi = disk.radius * disk.radius, distance2 = dot(segment, segment);
  const float leaving = -dot(segment, disk.normal), arriving = std::max(0.f, dot(segment, from.normal));
  return {position, leaving * arriving * area_over_pi / (form_factor * distance2 * distance2)};
}

// A place on a sphere, uniform in what the point sees of it.
LampPoints::Point pointOnSphere(const AnalyticLight::Side& sphere, const LitPoint& from, float form_factor,
                                float u1, float u2) {
  const SphereCone cone(from.point, sphere.corners[0], sphere.radius);
  const auto [w, distance] = cone.at(u1, u2);
  const Vec3 position = from.point + w * distance;
  const float arriving = dot(w, from.normal);
  if (!(arriving > 0 && dot(w, from.geometric_normal) > 0)) return {position, 0};
  return {position, arriving * cone.solidAngle() * std::numbers::inv_pi_v<float> / form_factor};
}

}  // namespace

void LampPoints::lookFrom(const LitPoint& from, Rgb reflectance) {
  from_ = from, ends_ = {}, unoccluded_ = {};
  int count = 0;
  for (const AnalyticLight::Side& side : light_.sides()) {
    Seen& seen = seen_[count];
    seen.side = &side;
    seen.part = side.radius > 0 ? Polygon{} : AnalyticLight::seen(side, from);
    seen.form_factor =
        side.radius > 0 ? AnalyticLight::formFactor(side, from) : AnalyticLight::formFactor(seen.part, from);
    const float reflected =
        seen.form_factor * luminance(reflectance * side.radiance) * strengths_[side.geometry];
    if (reflected > 0) {
      seen.sum = unoccluded_[side.group] += reflected;
      measure(seen), ++count;
    }
    ends_[side.group + 1] = count;
  }
}

void LampPoints::measure(Seen& seen) {
  if (seen.side->radius > 0) return;
  const Polygon& part = seen.part;
  seen.is_parallelogram = isParallelogram(part);
  for (std::size_t k = 2; k < part.count; ++k) {
    const Vec3 a = part.corners[0];
    const float area = length(cross(part.corners[k - 1] - a, part.corners[k] - a)) / 2;
    seen.areas[k] = seen.areas[k - 1] + area;
  }
  seen.weight = seen.areas[part.count - 1] * std::numbers::inv_pi_v<float> / seen.form_factor;
}

LampPoints::Point LampPoints::at(int group, float u, float u1, float u2) const {
  const int end = ends_[group + 1];
  int i = ends_[group];
  while (i + 1 < end && u * unoccluded_[group] >= seen_[i].sum) ++i;
  const Seen& seen = seen_[i];
  if (seen.side->form == AnalyticLight::Side::Form::kSphere)
    return pointOnSphere(*seen.side, from_, seen.form_factor, u1, u2);
  if (seen.side->form == AnalyticLight::Side::Form::kDisk)
    return pointOnDisk(seen.side->disk(), from_, seen.form_factor, u1, u2);
  const Vec3 segment = seen.is_parallelogram ? pointOnParallelogram(seen.part, u1, u2)
                                             : pointOn(seen.part, seen.areas, u1, u2);
  const float leaving = -dot(segment, seen.side->normal), arriving = dot(segment, from_.normal);
  const float distance2 = dot(segment, segment);
  return {from_.point + segment,
          std::max(0.f, leaving) * std::max(0.f, arriving) * seen.weight / (distance2 * distance2)};
}

}  // namespace saccade
