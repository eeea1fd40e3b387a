#include "render/lights/analytic_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/lights/disk_light.h"
#include "render/lights/lamp_lanes.h"
#include "render/lights/quads.h"
#include "render/lights/sphere_light.h"

namespace saccade {
namespace {

// Share of the cosine-weighted hemisphere about n that a polygon above the horizon covers [Lambert 1760].
float shareOfHemisphere(const Polygon& polygon, Vec3 n) {
  std::array<Vec3, Polygon::kMaxCorners> unit;
  for (std::size_t i = 0; i < polygon.count; ++i) unit[i] = normalize(polygon.corners[i]);
  float sum = 0;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Vec3 a = unit[i], b = unit[i + 1 < polygon.count ? i + 1 : 0];
    sum += angleOverSine(dot(a, b)) * dot(n, cross(a, b));
  }
  return std::abs(sum) * (0.5f * std::numbers::inv_pi_v<float>);
}

bool isEven(const Scene& scene, const Mesh& lamp) {
  return !isTextured(scene.materials[static_cast<std::size_t>(lamp.material)].emission);
}

// In lanes where no horizon cuts a disk or a sphere, and else one by one.
LampLanes::F ofRound(const LampLanes& seen_from, const AnalyticLight::Side& side, const LitPoints& points,
                     int first) {
  LaneSet cut;
  LampLanes::F factor = side.form == AnalyticLight::Side::Form::kDisk
                            ? seen_from.diskFormFactor(side.disk(), cut)
                            : seen_from.sphereFormFactor(side.corners[0], side.radius, cut);
  forEachLane(cut, [&](int i) { factor[i] = AnalyticLight::formFactor(side, points.at(first + i)); });
  return factor;
}

}  // namespace

AnalyticLight::AnalyticLight(const Scene& scene) : held_(scene.meshes.size() + scene.spheres.size()) {
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const Mesh& mesh = scene.meshes[i];
    if (emits(mesh) && isEven(scene, mesh)) addMesh(mesh, static_cast<std::uint32_t>(i));
  }
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
    const Sphere& s = scene.spheres[i];
    if (!emits(s) || sides_.size() == kMaxSides) continue;
    const std::size_t geometry = scene.meshes.size() + i;
    held_[geometry] = true;
    sides_.push_back({Side::Form::kSphere,
                      {s.center},
                      {},
                      s.radius,
                      s.radiance,
                      static_cast<std::uint32_t>(geometry),
                      nextGroup()});
  }
}

void AnalyticLight::addMesh(const Mesh& mesh, std::uint32_t geometry) {
  if (const auto disk = diskOf(mesh); disk && sides_.size() < kMaxSides) {
    held_[geometry] = true;
    sides_.push_back({Side::Form::kDisk,
                      {disk->center},
                      disk->normal,
                      disk->radius,
                      mesh.radiance,
                      geometry,
                      nextGroup()});
  } else if (sides_.size() + mesh.triangles.size() <= kMaxSides) {
    addSides(mesh, geometry);
  }
}

void AnalyticLight::addSides(const Mesh& mesh, std::uint32_t geometry) {
  held_[geometry] = true;
  const int group = nextGroup();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = mesh.triangles[i];
    Side side{Side::Form::kPolygon,
              {mesh.positions[a], mesh.positions[b], mesh.positions[c]},
              {},
              0,
              mesh.radiance,
              geometry,
              group};
    const auto edge = [&](std::size_t k) { return side.corners[k] - side.corners[0]; };
    const Vec3 normal = cross(edge(1), edge(2));
    if (dot(normal, normal) == 0) continue;
    side.normal = normalize(normal);
    if (isQuad(mesh, i)) side.corners.push_back(mesh.positions[mesh.triangles[++i][2]]);
    sides_.push_back(std::move(side));
  }
}

float AnalyticLight::formFactor(const Side& side, const LitPoint& p) {
  if (side.form == Side::Form::kSphere) return sphereFormFactor(side.corners[0], side.radius, p);
  if (side.form == Side::Form::kDisk) return diskFormFactor(side.disk(), p);
  return formFactor(seen(side, p), p);
}

Polygon AnalyticLight::seen(const Side& side, const LitPoint& p) {
  Polygon seen;
  if (!seesLamp<float>(p.point, side.corners, side.normal)) return seen;
  for (const Vec3 corner : side.corners) seen.add(corner - p.point);
  seen = above(seen, p.normal);
  return p.normal == p.geometric_normal ? seen : above(seen, p.geometric_normal);
}

float AnalyticLight::formFactor(const Polygon& seen, const LitPoint& p) {
  return shareOfHemisphere(seen, p.normal);
}

Rgb AnalyticLight::at(const LitPoint& p, const EmitterStrengths& strengths) const {
  Rgb sum;
  for (const Side& side : sides_)
    sum = sum + side.radiance * (formFactor(side, p) * strengths[side.geometry]);
  return sum;
}

void AnalyticLight::at(const LitPoints& points, LaneSet lanes, const EmitterStrengths& strengths,
                       LaneVectors& result) const {
  result = {};
  for (int first = 0; first < kLaneVectors; first += LampLanes::kLanes) {
    const LaneSet here = lanes.from(first) & LaneSet::first(LampLanes::kLanes);
    if (!here.any()) continue;
    const LampLanes seen_from(points.point, points.normal, points.geometric_normal, first, here);
    for (const Side& side : sides_) {
      const LampLanes::F factor = side.radius > 0 ? ofRound(seen_from, side, points, first)
                                                  : seen_from.formFactor(side.corners, side.normal);
      const auto light = splat<LampLanes::F>(side.radiance) * LampLanes::F(factor * strengths[side.geometry]);
      result.store(result.lanes<LampLanes::kLanes>(first) + light, first);
    }
  }
}

}  // namespace saccade
