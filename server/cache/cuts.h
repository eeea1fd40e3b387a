// Where walls cut the surroundings of vertices. Light does not pass there, so that a vertex keeps what lies
// on the one side, and another vertex at the same place what lies on the other side [ours].
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "cache/lanes.h"

namespace saccade {

// A plane. Points p with dot(normal, p) < offset are on its other side.
struct alignas(32) Cut {
  Vec3 normal{};
  float offset = 0;
  std::uint32_t other = 0;  // the vertex of the points there

  float heightOf(Vec3 p) const { return dot(normal, p) - offset; }
  Cut flipped(std::uint32_t vertex) const { return {-normal, -offset, vertex}; }
  Quad plane() const { return Quad{normal.x, normal.y, normal.z, offset}; }
};

// Those of the vertices of one level.
class Cuts {
 public:
  // That of a vertex; nullptr if there is none.
  const Cut* find(std::uint32_t vertex) const {
    const std::uint32_t number = numbers_[vertex];
    return number == 0 ? nullptr : &cuts_[number];
  }
  // That of a vertex, or one that has all points on its near side.
  const Cut& operator[](std::uint32_t vertex) const { return cuts_[numbers_[vertex]]; }
  // The vertex for a point near `vertex`: that one, or the one on the other side of its cut.
  std::uint32_t of(std::uint32_t vertex, Vec3 p) const {
    const Cut* cut = find(vertex);
    return cut && cut->heightOf(p) < 0 ? cut->other : vertex;
  }

  // Cuts what lies around a vertex: the other one has the same cut, from its side. A vertex has one at most.
  void add(std::uint32_t vertex, const Cut& cut) {
    numbers_[vertex] = static_cast<std::uint32_t>(cuts_.size());
    cuts_.push_back(cut);
    numbers_[cut.other] = static_cast<std::uint32_t>(cuts_.size());
    cuts_.push_back(cut.flipped(vertex));
  }
  void resize(std::size_t vertices) { numbers_.resize(vertices); }
  // Keeps the vertices whose `kept` is true: both of a cut or none. `moved`: their new indices.
  void keep(const std::vector<bool>& kept, const std::vector<std::uint32_t>& moved);
  // f(vertex, cut), once for each cut.
  void forEach(const auto& f) const {
    for (std::size_t i = 1; i < cuts_.size(); i += 2) f(cuts_[i + 1].other, cuts_[i]);
  }

 private:
  std::vector<std::uint32_t> numbers_;  // by vertex: of its cut, or 0
  std::vector<Cut> cuts_{Cut{{}, -1}};  // the first has nothing on its other side; then both sides of each
};

// Four vertices, with their cuts side by side.
class CutTaps {
 public:
  CutTaps() = default;
  CutTaps(const Cuts& cuts, const Indices& vertices) : vertices_(vertices) {
    const Cut &a = cuts[vertices[0]], &b = cuts[vertices[1]], &c = cuts[vertices[2]], &d = cuts[vertices[3]];
    x_ = a.plane(), y_ = b.plane(), z_ = c.plane(), offset_ = d.plane();
    _MM_TRANSPOSE4_PS(x_, y_, z_, offset_);
    others_ = Indices{a.other, b.other, c.other, d.other};
  }
  // Those for a point: Cuts::of().
  Indices of(Vec3 p) const {
    const auto is_other = x_ * p.x + y_ * p.y + z_ * p.z < offset_;
    return is_other ? others_ : vertices_;
  }

 private:
  Indices vertices_{}, others_{};
  Quad x_{}, y_{}, z_{}, offset_{};
};

}  // namespace saccade
