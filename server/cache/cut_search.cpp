#include "cache/cut_search.h"

#include <algorithm>
#include <cmath>

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

// The vertex of a key that lies nearest to a point, of those that share it.
Vec3 placeNear(VertexKey key, Vec3 p, float h) {
  const Vec3d at = Tetrahedron::placeOf(key), from = toDouble(p) / static_cast<double>(h);
  constexpr double kRange = Tetrahedron::kAddressMask + 1.;
  const auto coordinate = [&](double c, double near) {
    return static_cast<float>((near + std::remainder(c - near, kRange)) * h);
  };
  return {coordinate(at.x, from.x), coordinate(at.y, from.y), coordinate(at.z, from.z)};
}

Cut facing(Vec3 p, Vec3 normal, Vec3 on_plane) {
  if (dot(normal, p - on_plane) < 0) normal = -normal;
  return {normal, dot(normal, on_plane)};
}

// Whether a plane cuts the cube of edge 2 h around a vertex.
bool cuts(const Cut& cut, Vec3 place, float h) {
  const Vec3 n = cut.normal;
  return std::abs(cut.heightOf(place)) < h * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
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
    auto cut = slot < kProbedSlot ? inherit(p, slot, place, h) : probe(p, place, h);
    if (!cut) {
      level.table.unmark(v.place);
      continue;
    }
    cut->other = level.table.indexAt(finder.find(behind(v.key)));
    level.resize();
    level.cuts.add(v.index, *cut);
  }
}

std::optional<Cut> CutSearch::inherit(const GridPoint& p, int slot, Vec3 place, float h) const {
  const Cuts& coarser = levels_[p.level + slot + 1].cuts;
  std::optional<Cut> nearest;
  for (std::uint32_t t = p.first; t < p.first + p.count; ++t) {
    for (const std::uint32_t v : at_.taps[slot + 1][t].vertex) {
      const Cut* cut = coarser.find(v);
      if (!cut || !cuts(*cut, place, h)) continue;
      if (!nearest || std::abs(cut->heightOf(p.position)) < std::abs(nearest->heightOf(p.position)))
        nearest = *cut;
    }
  }
  if (nearest && nearest->heightOf(p.position) < 0) return nearest->flipped(0);
  return nearest;
}

std::optional<Cut> CutSearch::probe(const GridPoint& p, Vec3 place, float h) const {
  if (!on_.obstacles) return {};
  const Vec3 n = on_.place(p.index).normal;
  Obstacles::Ways ways;
  for (std::size_t i = 0; i < kDirections.size(); ++i) {
    const Vec3 d = kDirections[i], from = p.position + n * (dot(d, n) < -kSide ? -h * kClose : h * kLift);
    ways[i] = {from, d, std::max(0.f, dot(d, place - from) + h)};
  }
  const Obstacles::Met met = on_.obstacles->find(ways);
  std::array<std::size_t, kDirections.size()> order{0, 1, 2, 3, 4, 5};
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return met[i].distance; });
  for (const std::size_t i : order) {  // the nearest first
    if (!std::isfinite(met[i].distance)) break;
    const Vec3 hit = ways[i].from + ways[i].along * met[i].distance;
    const float along = dot(ways[i].along, n);
    if (along < -kSide) {
      if (isAlike(met[i].normal, n)) return facing(p.position, n, (hit + p.position) * 0.5f);
    } else if (along > kSide ? isAbove(ways[i], met[i], n, h) : isBeside(ways[i], met[i], n, h)) {
      return facing(p.position, met[i].normal, hit);
    }
  }
  return {};
}

// Whether there is another surface of this normal above what has been met.
bool CutSearch::isAbove(const Obstacles::Way& way, const Obstacle& met, Vec3 n, float h) const {
  const float begin = met.distance + h * kClose;
  const Obstacles::Met above =
      on_.obstacles->find({{{way.from + way.along * begin, way.along, way.reach - begin}}});
  return isAlike(above[0].normal, n);
}

// Whether the surface, or another one of its normal, goes on beside what has been met.
bool CutSearch::isBeside(const Obstacles::Way& way, const Obstacle& met, Vec3 n, float h) const {
  if (isAlike(met.normal, n)) return false;
  Obstacles::Ways down;
  for (int i = 0; i < Obstacles::kWays; ++i) {
    const float share = (static_cast<float>(i) + 0.5f) / Obstacles::kWays;
    down[i] = {way.from + way.along * (met.distance + share * (way.reach - met.distance)), -n, h};
  }
  return std::ranges::any_of(on_.obstacles->find(down),
                             [&](const Obstacle& o) { return isAlike(o.normal, n); });
}

void leadAround(const GridLevel& level, int l, const NewVertices& found, Placement& at) {
  for (const auto& [point, tap] : found.taps) {
    const GridPoint& p = at.points[point];
    for (std::uint32_t& v : at.taps[l - p.level][tap].vertex) v = level.cuts.of(v, p.position);
  }
}

}  // namespace saccade
