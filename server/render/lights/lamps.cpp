#include "render/lights/lamps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/lights/delta_samples.h"
#include "render/lights/disk.h"
#include "render/lights/quads.h"
#include "render/lights/sphere_cone.h"

namespace saccade {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

LampBounds boundsOfSpot(const SpotLight& spot) {
  LampBounds all{spot.position, spot.position, spot.axis, kPi, 0, 1, luminance(spot.intensity)};
  if (spot.beam < kPi) all.spread = 0, all.dark = std::cos(spot.cutoff), all.bright = std::cos(spot.beam);
  return all;
}

// The box has the sphere's radius, not its edges.
LampBounds boundsOfSphere(const AreaLamp& lamp) {
  const Vec3 half = Vec3{1, 1, 1} * (lamp.radius / std::numbers::sqrt3_v<float>);
  const float strength = luminance(lamp.radiance) * kPi * lamp.radius * lamp.radius;
  return {lamp.corner - half, lamp.corner + half, {0, 0, 1}, kPi, 0, 1, strength};
}

LampBounds boundsOfTriangle(const AreaLamp& lamp) {
  const Vec3 a = lamp.corner, normal = normalize(cross(lamp.edge1, lamp.edge2));
  LampBounds all{a, a, normal, 0, 0, 1, luminance(lamp.radiance) * lamp.area()};
  for (const Vec3 corner : {a + lamp.edge1, a + lamp.edge2}) all = merged(all, {corner, corner, normal});
  return all;
}

// Whether the triangles of a disk have equal areas, as those around its centre have.
bool isEvenDisk(const Mesh& mesh) {
  const auto area = [&](const auto& triangle) {
    const Vec3 a = mesh.positions[triangle[0]];
    return length(cross(mesh.positions[triangle[1]] - a, mesh.positions[triangle[2]] - a));
  };
  const auto isEven = [&](const auto& triangle) {
    const float first = area(mesh.triangles[0]);
    return std::abs(area(triangle) - first) < 1e-2f * first;
  };
  return diskOf(mesh) && std::ranges::all_of(mesh.triangles, isEven);
}

ChosenLamp memberOf(const LampLeaf& leaf, float probability, float u) {
  const float others = static_cast<float>(leaf.count) - 1;
  const float place = (u - leaf.first_share) / (1 - leaf.first_share) * others;
  const std::uint32_t member =
      u < leaf.first_share ? 0 : 1 + static_cast<std::uint32_t>(std::min(place, others - 1));
  return {leaf.first + member, probability / leaf.area};
}

}  // namespace

AreaLamp::Place AreaLamp::at(float u1, float u2) const {
  if (radius > 0) {
    const float z = 1 - 2 * u1, r = std::sqrt(std::max(0.f, 1 - z * z)), phi = 2 * kPi * u2;
    const Vec3 normal{r * std::cos(phi), r * std::sin(phi), z};
    return {corner + normal * radius, normal};
  }
  const float s = std::sqrt(u1);  // the square-root map
  return {corner + edge1 * (1 - s) + edge2 * (u2 * s), normalize(cross(edge1, edge2))};
}

float AreaLamp::area() const {
  return radius > 0 ? 4 * kPi * radius * radius : length(cross(edge1, edge2)) / 2;
}

Lamps::Lamps(const Scene& scene, const std::vector<Texture>& textures)
    : textures_(&textures), spots_(spotsOf(scene)) {
  std::uint32_t geometry = 0;  // counted as EmbreeScene does
  const auto next = [&] {
    first_primitive_.push_back(static_cast<std::uint32_t>(leaf_of_primitive_.size()));
  };
  for (const Mesh& mesh : scene.meshes) {
    next();
    if (emits(mesh))
      addMesh(mesh, geometry, scene.materials[static_cast<std::size_t>(mesh.material)].emission);
    ++geometry;
  }
  for (const Sphere& sphere : scene.spheres) {
    next();
    const AreaLamp lamp{sphere.center, {}, {}, sphere.radius, sphere.radiance, geometry++};
    if (emits(sphere)) addLeaf({&lamp, 1});
  }
  addSets();
}

void Lamps::addMesh(const Mesh& mesh, std::uint32_t geometry, const SurfaceColor& emission) {
  const auto lamp = [&](std::size_t i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const Vec3 corner = mesh.positions[a];
    return AreaLamp{corner,  mesh.positions[b] - corner, mesh.positions[c] - corner, 0, mesh.radiance,
                    geometry};
  };
  const std::size_t all = isEvenDisk(mesh) ? mesh.triangles.size() : 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::size_t first = i;
    std::vector<AreaLamp> lamps{lamp(i)};
    while (lamps.size() < all || (lamps.size() == 1 && isQuad(mesh, i))) lamps.push_back(lamp(++i));
    if (isTextured(emission)) addPictures(mesh, first, emission, lamps);
    addLeaf(lamps);
  }
}

// Gives the lamps of a leaf, from a triangle on, their pictures, and all of them the mean light.
void Lamps::addPictures(const Mesh& mesh, std::size_t first, const SurfaceColor& emission,
                        std::span<AreaLamp> lamps) {
  Rgb power;
  float area = 0;
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    lamps[i].picture = static_cast<int>(pictures_.size());
    pictures_.emplace_back(mesh, mesh.triangles[first + i], emission);
    power = power + pictures_.back().mean(*textures_) * lamps[i].area();
    area += lamps[i].area();
  }
  for (AreaLamp& lamp : lamps)
    if (area > 0) lamp.radiance = power / area;
}

void Lamps::addLeaf(std::span<const AreaLamp> lamps) {
  LampLeaf leaf{static_cast<std::uint32_t>(area_lamps_.size()), 0, 0};
  for (const AreaLamp& lamp : lamps) {
    leaf_of_primitive_.push_back(static_cast<std::uint32_t>(leaves_.size()));
    const float area = lamp.area();
    if (!(area > 0)) continue;
    area_lamps_.push_back(lamp);
    ++leaf.count, leaf.area += area;
  }
  if (leaf.count == 0) return;
  leaf.first_share = area_lamps_[leaf.first].area() / leaf.area;
  leaves_.push_back(leaf);
}

void Lamps::addSets() {
  std::vector<float> power;  // over pi
  std::vector<LampBounds> bounds;
  const auto add = [&](Set& set) {
    set.by_power = LightChoice(power);
    if (bounds.size() > 1 && !set.by_power.empty()) set.tree.emplace(bounds);
  };
  for (const AreaLamp& lamp : area_lamps_) power.push_back(luminance(lamp.radiance) * lamp.area());
  for (const LampLeaf& leaf : leaves_) bounds.push_back(boundsOf(leaf));
  add(sets_[1]);
  for (const SpotLight& spot : spots_) {
    power.push_back(2 * (1 - std::cos(spot.cutoff)) * luminance(spot.intensity));
    bounds.push_back(boundsOfSpot(spot));
    leaves_.push_back({static_cast<std::uint32_t>(power.size()) - 1, 1, 1});
  }
  add(sets_[0]);
}

LampBounds Lamps::boundsOf(const LampLeaf& leaf) const {
  const AreaLamp* lamp = &area_lamps_[leaf.first];
  if (lamp->radius > 0) return boundsOfSphere(*lamp);
  LampBounds all = boundsOfTriangle(*lamp);
  for (std::uint32_t i = 1; i < leaf.count; ++i) all = merged(all, boundsOfTriangle(lamp[i]));
  return all;
}

ChosenLamp Lamps::choose(LightSet set, const Receiver& at, float u_lamp) const {
  if (!hasTree(set)) {
    const auto i = static_cast<std::uint32_t>(byPower(set).choose(u_lamp));
    if (i >= area_lamps_.size()) return {i, byPower(set).probability(i)};
    return {i, luminance(area_lamps_[i].radiance) * byPower(set).inverseWeight()};
  }
  const LampTree::Chosen chosen = tree(set).choose(at, u_lamp);
  return memberOf(leaves_[chosen.lamp], chosen.probability, chosen.u);
}

Lamps::ChosenLanes Lamps::chooseFromTree(LightSet set, const LaneVectors& points, const LaneVectors& normals,
                                         const float* u, LaneSet lanes) const {
  LampTree::ChosenLanes chosen;
  std::copy_n(u, kLaneVectors, chosen.u);
  tree(set).choose(points, normals, lanes, chosen);
  ChosenLanes out;
  forEachLane(lanes, [&](int i) {
    const ChosenLamp one = memberOf(leaves_[chosen.lamp[i]], chosen.probability[i], chosen.u[i]);
    out.number[i] = one.number, out.pdf[i] = one.pdf;
  });
  return out;
}

float Lamps::pdf(LightSet set, const EmitterPoint& point, const Receiver& at) const {
  const std::uint32_t number = leaf_of_primitive_[first_primitive_[point.geometry] + point.primitive];
  const LampLeaf& leaf = leaves_[number];
  const float per_area = hasTree(set)
                             ? probability(set, number, at) / leaf.area
                             : luminance(area_lamps_[leaf.first].radiance) * byPower(set).inverseWeight();
  if (const AreaLamp& lamp = area_lamps_[leaf.first]; lamp.radius > 0)
    return per_area * lamp.area() / SphereCone(at.point, lamp.corner, lamp.radius).solidAngle();
  return per_area * point.distance * point.distance / std::max(point.cosine, 1e-6f);
}

IncidentLight Lamps::sample(const ChosenLamp& lamp, Vec3 point, float u1, float u2) const {
  if (lamp.number < area_lamps_.size()) {
    const AreaLamp& area = area_lamps_[lamp.number];
    return area.radius > 0 ? ofSphere(area, lamp.pdf, point, u1, u2)
                           : ofTriangle(area, lamp.pdf, point, u1, u2);
  }
  return sampleOf(spots_[lamp.number - area_lamps_.size()], point, lamp.pdf);
}

// `pdf`: per area.
IncidentLight Lamps::ofTriangle(const AreaLamp& lamp, float pdf, Vec3 point, float u1, float u2) const {
  const auto [on_lamp, normal] = lamp.at(u1, u2);
  const Vec3 segment = on_lamp - point;
  const float distance2 = dot(segment, segment);
  const Vec3 w = segment / std::sqrt(distance2);
  const float cosine = -dot(w, normal);
  const float per_solid_angle = cosine > 0 ? pdf * distance2 / cosine : 0;
  const Rgb radiance = lamp.picture < 0
                           ? lamp.radiance
                           : pictures_[static_cast<std::size_t>(lamp.picture)].at(*textures_, u1, u2);
  return {w, segment, kShadowEnd, radiance, per_solid_angle, false, lamp.geometry};
}

// `pdf`: as if it were per area.
IncidentLight Lamps::ofSphere(const AreaLamp& lamp, float pdf, Vec3 point, float u1, float u2) const {
  const SphereCone cone(point, lamp.corner, lamp.radius);
  if (!cone.isOutside()) return {};
  const auto [w, distance] = cone.at(u1, u2);
  const float per_solid_angle = pdf * lamp.area() / cone.solidAngle();
  return {w, w * distance, kShadowEnd, lamp.radiance, per_solid_angle, false, lamp.geometry};
}

}  // namespace saccade
