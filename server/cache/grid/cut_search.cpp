#include "cache/grid/cut_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace saccade {
namespace {

constexpr int kProbedSlot = 2;  // cells that are finer take the cuts of coarser ones: rays cost more there
constexpr float kLift = 0.25f;  // of a cell: what is lower than that is no wall
constexpr float kClose = 1.f / 64;  // of a cell: just off a surface

const std::array<Vec3, 6> kDirections{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};

// How a direction lies to a normal: cosines.
constexpr float kSide = 0.3f, kAlike = 0.7f;
bool isAlike(Vec3 normal, Vec3 n) {
  return std::abs(dot(normal, n)) > kAlike;
}
bool isDownwards(Vec3 along, Vec3 n) {
  return dot(along, n) < -kSide;
}
bool isUpwards(Vec3 along, Vec3 n) {
  return isDownwards(along, -n);
}

// The vertex of a key that lies nearest to a point, of those that share it.
Vec3 placeNear(VertexKey key, Vec3 p, float h) {
  const Vec3d at = Tetrahedron::placeOf(key), from = toDouble(p) / static_cast<double>(h);
  constexpr double kRange = Tetrahedron::kAddressMask + 1.;
  const auto coordinate = [&](double c, double near) {
    return static_cast<float>((near + std::remainder(c - near, kRange)) * h);
  };
  return {coordinate(at.x, from.x), coordinate(at.y, from.y), coordinate(at.z, from.z)};
}

CutPlane planeAt(Vec3 on_plane, Vec3 normal) {
  return {normal, dot(normal, on_plane)};
}

// The plane of what a point of normal n meets in a direction. It lies between the surfaces that face alike.
CutPlane planeOf(Vec3 p, Vec3 along, Vec3 hit, Vec3 normal, Vec3 n, float h) {
  if (isDownwards(along, n)) return planeAt((hit + p) * 0.5f, n);
  return planeAt(isUpwards(along, n) ? hit - along * (h * kClose) : hit, normal);
}

// Whether a plane cuts the cube of edge 2 h around a vertex.
bool cuts(const CutPlane& plane, Vec3 place, float h) {
  const Vec3 n = plane.normal;
  return std::abs(plane.heightOf(place)) < h * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
}

}  // namespace

void CutSearch::cut(int l, const NewVertices& added) {
  GridLevel& level = levels_[l];
  const float h = std::ldexp(1.f, l);
  VertexTable::Finder finder(level.table, now_);
  for (const NewVertices::Vertex& v : added.vertices) {
    const GridPoint& p = at_.points[v.point];
    const int slot = l - p.level;
    const Vec3 place = placeNear(v.key, p.position, h);
    const CutPlanes planes = slot < kProbedSlot ? inherit(p, slot, place, h) : probe(p, place, h);
    if (planes.empty()) {
      level.table.unmark(v.place);
      continue;
    }
    Cut cut{planes, {v.index}};
    for (std::uint32_t side = 1; side < planes.sides(); ++side)
      cut.vertices[side] = level.table.indexAt(finder.find(onSide(v.key, side)));
    level.resize();
    level.cuts.add(cut);
  }
}

void CutSearch::forEachCoarser(const GridPoint& p, int slot, const auto& f) const {
  const Cuts& coarser = levels_[p.level + slot + 1].cuts;
  for (std::uint32_t t = p.first; t < p.first + p.count; ++t)
    for (const std::uint32_t v : at_.taps[slot + 1][t].vertex)
      if (const Cut* cut = coarser.find(v)) std::ranges::for_each(cut->planes, f);
}

CutPlanes CutSearch::inherit(const GridPoint& p, int slot, Vec3 place, float h) const {
  CutPlanes planes;
  while (!planes.full()) {
    CutPlane nearest{.offset = -std::numeric_limits<float>::infinity()};
    forEachCoarser(p, slot, [&](const CutPlane& coarser) {
      const CutPlane plane = coarser.facing(p.position);
      const bool is_nearer = plane.heightOf(p.position) < nearest.heightOf(p.position);
      if (is_nearer && cuts(plane, place, h) && planes.lack(plane)) nearest = plane;
    });
    if (nearest.normal == Vec3{}) break;
    planes.add(nearest);
  }
  return planes;
}

CutPlanes CutSearch::probe(const GridPoint& p, Vec3 place, float h) const {
  CutPlanes planes;
  if (!obstacles_) return planes;
  const Vec3 n = on_.place(p.index).normal;
  Obstacles::ProbeRays rays;
  for (std::size_t i = 0; i < kDirections.size(); ++i) {
    const Vec3 d = kDirections[i], from = p.position + n * (isDownwards(d, n) ? -h * kClose : h * kLift);
    rays[i] = {from, d, std::max(0.f, dot(d, place - from) + h)};
  }
  // To what is neither beside nor above the point, but across the vertex from it.
  const Vec3 across = place - p.position, along_surface = across - n * dot(across, n);
  if (const float distance = length(along_surface); distance > 0)
    rays[kDirections.size()] = {p.position + n * (h * kLift), along_surface / distance, distance + h};
  const Obstacles::Hits met = obstacles_->find(rays);
  std::array<std::size_t, kDirections.size() + 1> order{0, 1, 2, 3, 4, 5, 6};
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return met[i].distance; });
  for (const std::size_t i : order) {  // the nearest first
    if (!std::isfinite(met[i].distance)) break;
    const Vec3 hit = rays[i].from + rays[i].along * met[i].distance;
    const CutPlane facing = planeOf(p.position, rays[i].along, hit, met[i].normal, n, h).facing(p.position);
    if (planes.lack(facing) && isWall(rays[i], met[i], n, h)) planes.add(facing);
  }
  return planes;
}

// Whether a surface of normal n goes on behind what has been met.
bool CutSearch::isWall(const Obstacles::ProbeRay& ray, const Obstacle& met, Vec3 n, float h) const {
  if (isDownwards(ray.along, n)) return isAlike(met.normal, n);
  return isUpwards(ray.along, n) ? isAbove(ray, met, n, h) : isBeside(ray, met, n, h);
}

// Whether there is another surface of this normal above what has been met: that may be its other side.
bool CutSearch::isAbove(const Obstacles::ProbeRay& ray, const Obstacle& met, Vec3 n, float h) const {
  if (isAlike(met.normal, n)) return true;
  const float begin = met.distance + h * kClose;
  const Obstacles::Hits above =
      obstacles_->find({{{ray.from + ray.along * begin, ray.along, ray.reach - begin}}});
  return isAlike(above[0].normal, n);
}

// Whether the surface, or another one of its normal, goes on beside what has been met.
bool CutSearch::isBeside(const Obstacles::ProbeRay& ray, const Obstacle& met, Vec3 n, float h) const {
  if (isAlike(met.normal, n)) return false;
  Obstacles::ProbeRays down;
  for (int i = 0; i < Obstacles::kRays; ++i) {
    const float share = (static_cast<float>(i) + 0.5f) / Obstacles::kRays;
    down[i] = {ray.from + ray.along * (met.distance + share * (ray.reach - met.distance)), -n, h};
  }
  return std::ranges::any_of(obstacles_->find(down), [&](const Obstacle& o) { return isAlike(o.normal, n); });
}

void remapTaps(const GridLevel& level, int l, const NewVertices& found, Placement& at) {
  for (const auto& [point, tap] : found.taps) {
    const GridPoint& p = at.points[point];
    for (std::uint32_t& v : at.taps[l - p.level][tap].vertex) v = level.cuts.of(v, p.position);
  }
}

}  // namespace saccade
