#include "render/lights/analytic_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "render/lights/lamp_lanes.h"
#include "render/lights/quads.h"

namespace saccade {
namespace {

constexpr std::size_t kMaxSides = 16;  // more cost more than their shadows tell
constexpr std::size_t kMaxCorners = 8;

struct Polygon {
  std::array<Vec3, kMaxCorners> corners;
  std::size_t count = 0;
  void add(Vec3 v) {
    if (count < kMaxCorners) corners[count++] = v;
  }
};

// The part of a polygon, seen from the origin, that is above the plane with normal n.
Polygon above(const Polygon& in, Vec3 n) {
  bool all = true;
  for (std::size_t i = 0; i < in.count; ++i) all = all && dot(in.corners[i], n) > 0;
  if (all) return in;
  Polygon out;
  for (std::size_t i = 0; i < in.count; ++i) {
    const Vec3 a = in.corners[i], b = in.corners[i + 1 < in.count ? i + 1 : 0];
    const float height_a = dot(a, n), height_b = dot(b, n);
    if (height_a > 0) out.add(a);
    if ((height_a > 0) != (height_b > 0)) out.add(a + (b - a) * (height_a / (height_a - height_b)));
  }
  return out;
}

// Share of the cosine-weighted hemisphere about n that a polygon above the horizon covers [Lambert 1760].
float formFactor(const Polygon& polygon, Vec3 n) {
  std::array<Vec3, kMaxCorners> unit;
  for (std::size_t i = 0; i < polygon.count; ++i) unit[i] = normalize(polygon.corners[i]);
  float sum = 0;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Vec3 a = unit[i], b = unit[i + 1 < polygon.count ? i + 1 : 0];
    sum += angleOverSine(dot(a, b)) * dot(n, cross(a, b));
  }
  return std::abs(sum) * (0.5f * std::numbers::inv_pi_v<float>);
}

}  // namespace

AnalyticLight::AnalyticLight(const Scene& scene)
    : held_(scene.meshes.size()),
      point_lights_(scene.point_lights),
      spot_lights_(scene.spot_lights),
      directional_lights_(scene.directional_lights) {
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const Mesh& mesh = scene.meshes[i];
    if (emits(mesh) && sides_.size() + mesh.triangles.size() <= kMaxSides)
      addSides(mesh, static_cast<std::uint32_t>(i));
  }
}

void AnalyticLight::addSides(const Mesh& mesh, std::uint32_t geometry) {
  held_[geometry] = true;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = mesh.triangles[i];
    Side side{{mesh.positions[a], mesh.positions[b], mesh.positions[c]}, {}, mesh.radiance, geometry};
    const Vec3 normal = cross(side.corners[1] - side.corners[0], side.corners[2] - side.corners[0]);
    if (dot(normal, normal) == 0) continue;
    side.normal = normalize(normal);
    if (isQuad(mesh, i)) side.corners.push_back(mesh.positions[mesh.triangles[++i][2]]);
    sides_.push_back(std::move(side));
  }
}

Rgb AnalyticLight::from(const Side& side, const LitPoint& p, float strength) {
  if (!seesLamp<float>(p.point, side.corners, side.normal)) return {};
  Polygon seen;
  for (const Vec3 corner : side.corners) seen.add(corner - p.point);
  seen = above(seen, p.normal);
  if (!(p.normal == p.geometric_normal)) seen = above(seen, p.geometric_normal);
  return side.radiance * (formFactor(seen, p.normal) * strength);
}

Rgb AnalyticLight::fromPointsAndDirections(const LitPoint& p) const {
  Rgb sum;
  const auto addFrom = [&](Vec3 w, Rgb irradiance) {
    if (dot(w, p.geometric_normal) <= 0) return;
    sum = sum + irradiance * (std::max(0.f, dot(w, p.normal)) * std::numbers::inv_pi_v<float>);
  };
  const auto addFromPoint = [&](Vec3 position, const auto& intensityTowards) {
    const Vec3 segment = position - p.point;
    const float distance2 = dot(segment, segment);
    const Vec3 w = segment / std::sqrt(distance2);
    addFrom(w, intensityTowards(-w) / distance2);
  };
  for (const PointLight& l : point_lights_) addFromPoint(l.position, [&](Vec3) { return l.intensity; });
  for (const SpotLight& l : spot_lights_)
    addFromPoint(l.position, [&](Vec3 direction) { return intensityTowards(l, direction); });
  for (const DirectionalLight& l : directional_lights_) addFrom(-l.direction, l.irradiance);
  return sum;
}

Rgb AnalyticLight::at(const LitPoint& p, const EmitterStrengths& strengths) const {
  Rgb sum = fromPointsAndDirections(p);
  for (const Side& side : sides_) sum = sum + from(side, p, strengths[side.geometry]);
  return sum;
}

void AnalyticLight::at(const LitPoints& points, LaneSet lanes, const EmitterStrengths& strengths,
                       LaneVectors& result) const {
  if (!point_lights_.empty() || !spot_lights_.empty() || !directional_lights_.empty())
    forEachLane(lanes, [&](int i) { result.set(i, fromPointsAndDirections(points.at(i))); });
  else
    result = {};
  for (int first = 0; first < kLaneVectors; first += LampLanes::kLanes) {
    const LaneSet here = lanes.from(first) & LaneSet::first(LampLanes::kLanes);
    if (!here.any()) continue;
    const LampLanes seen_from(points.point, points.normal, points.geometric_normal, first, here);
    for (const Side& side : sides_) {
      const LampLanes::F factor = seen_from.formFactor(side.corners, side.normal);
      const auto light = splat<LampLanes::F>(side.radiance) * LampLanes::F(factor * strengths[side.geometry]);
      result.store(result.lanes<LampLanes::kLanes>(first) + light, first);
    }
  }
}

}  // namespace saccade
