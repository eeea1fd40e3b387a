// Where walls cut the surroundings of vertices. Light does not pass there. So a vertex keeps the light of one
// side of them, and others at the same place keep that of other sides [ours].
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "cache/lattice/lanes.h"

namespace saccade {

// Points p with dot(normal, p) < offset are behind it.
struct CutPlane {
  Vec3 normal{};  // unit, or 0: all points are in front
  float offset = -1;

  float heightOf(Vec3 p) const { return dot(normal, p) - offset; }
  bool isBehind(Vec3 p) const { return heightOf(p) < 0; }
  // The same plane with a point in front.
  CutPlane facing(Vec3 p) const { return isBehind(p) ? CutPlane{-normal, -offset} : *this; }
  Quad quad() const { return Quad{normal.x, normal.y, normal.z, offset}; }
};

// Up to two planes, as of walls that meet in a corner, or stand on both sides of a corridor. A side has the
// number 0, plus 1 if it is behind the first plane, plus 2 if it is behind the second.
class CutPlanes {
 public:
  static constexpr std::uint32_t kSides = 4;

  bool empty() const { return count_ == 0; }
  bool full() const { return count_ == planes_.size(); }
  std::uint32_t sides() const { return 1u << count_; }
  // Whether there is room for a plane, and none looks the same way.
  bool lack(const CutPlane& plane) const {
    constexpr float kSameWay = 0.7f;
    return !full() && !(dot(planes_[0].normal, plane.normal) > kSameWay);
  }
  void add(const CutPlane& plane) { planes_[count_++] = plane; }
  std::uint32_t sideOf(Vec3 p) const {
    return std::uint32_t{planes_[0].isBehind(p)} + 2 * std::uint32_t{planes_[1].isBehind(p)};
  }
  const std::array<CutPlane, 2>& all() const { return planes_; }
  const CutPlane* begin() const { return planes_.data(); }
  const CutPlane* end() const { return begin() + count_; }

 private:
  std::array<CutPlane, 2> planes_;
  std::size_t count_ = 0;
};

struct Cut {
  CutPlanes planes;
  std::array<std::uint32_t, CutPlanes::kSides> vertices{};  // by side, as many as there are

  std::uint32_t of(Vec3 p) const { return vertices[planes.sideOf(p)]; }
  void forEachVertex(const auto& f) const {
    for (std::uint32_t side = 0; side < planes.sides(); ++side) f(vertices[side]);
  }
};

// Those of the vertices of one level.
class Cuts {
 public:
  // That of a vertex of any side; nullptr if there is none.
  const Cut* find(std::uint32_t vertex) const {
    const std::uint32_t number = numbers_[vertex];
    return number == 0 ? nullptr : &cuts_[number];
  }
  // That of a vertex, or one without planes.
  const Cut& operator[](std::uint32_t vertex) const { return cuts_[numbers_[vertex]]; }
  // The vertex for a point near `vertex`.
  std::uint32_t of(std::uint32_t vertex, Vec3 p) const {
    const Cut* cut = find(vertex);
    return cut ? cut->of(p) : vertex;
  }

  // Of vertices that have none yet.
  void add(const Cut& cut) {
    cut.forEachVertex([&](std::uint32_t v) { numbers_[v] = static_cast<std::uint32_t>(cuts_.size()); });
    cuts_.push_back(cut);
  }
  void resize(std::size_t vertices) { numbers_.resize(vertices); }
  // Keeps the vertices whose `kept` is true: all of a cut or none. `moved`: their new indices.
  void keep(const std::vector<bool>& kept, const std::vector<std::uint32_t>& moved);
  void forEach(const auto& f) const {
    for (std::size_t i = 1; i < cuts_.size(); ++i) f(cuts_[i]);
  }

 private:
  std::vector<std::uint32_t> numbers_;  // by vertex: of its cut, or 0
  std::vector<Cut> cuts_{Cut{}};        // the first has no planes
};

// Four vertices, with their cuts side by side.
class CutTaps {
 public:
  CutTaps() = default;
  CutTaps(const Cuts& cuts, const Indices& vertices) {
    std::array<const Cut*, 4> of;
    for (int i = 0; i < 4; ++i) {
      of[i] = &cuts[vertices[i]];
      for (std::size_t side = 0; side < of_side_.size(); ++side)
        of_side_[side][i] = of[i]->planes.empty() ? vertices[i] : of[i]->vertices[side];
    }
    for (std::size_t k = 0; k < planes_.size(); ++k) {
      const auto quad = [&](int i) { return of[i]->planes.all()[k].quad(); };
      auto& [x, y, z, offset] = planes_[k];
      x = quad(0), y = quad(1), z = quad(2), offset = quad(3);
      _MM_TRANSPOSE4_PS(x, y, z, offset);
    }
  }
  // Those for a point: Cuts::of().
  Indices of(Vec3 p) const {
    const auto is_behind = [&](const Planes& s) { return s.x * p.x + s.y * p.y + s.z * p.z < s.offset; };
    const auto first = is_behind(planes_[0]), second = is_behind(planes_[1]);
    return second ? (first ? of_side_[3] : of_side_[2]) : (first ? of_side_[1] : of_side_[0]);
  }

 private:
  struct Planes {
    Quad x{}, y{}, z{}, offset{};
  };
  std::array<Indices, CutPlanes::kSides> of_side_{};
  std::array<Planes, 2> planes_;
};

}  // namespace saccade
