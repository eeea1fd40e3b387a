// The state of the grid: on each level its vertices, and at each vertex sums of samples.
#pragma once

#include <array>
#include <memory>

#include "base/check.h"
#include "base/huge_pages.h"
#include "cache/grid/cuts.h"
#include "cache/grid/vertex_table.h"
#include "cache/lattice/lanes.h"
#include "cache/lattice/placement.h"

namespace saccade {

// Adds up steps of light, by weight.
struct MeanStep {
  float weight = 0, sum = 0;
  MeanStep operator*(float w) const { return {weight * w, sum * w}; }
  void operator+=(const MeanStep& other) { weight += other.weight, sum += other.sum; }
};

struct GridLevel {
  VertexTable table;
  // Sums over samples of weight, residual, visible / U and unoccluded / U (the two estimates by paths).
  HugeVector<Quad> light;
  // Evidence of the level kPoolSteps below, for `residual` and then for visibility: sums of x, x^2, squared
  // deviations, and weights of samples. evidence.h defines x.
  HugeVector<Octet> evidence;
  Cuts cuts;
  // When fade() was at a vertex, as the grid counts frames; empty where no light has moved.
  std::vector<std::uint32_t> faded;
  // Of moveOn(), which leaves zeros; empty where no light has moved.
  HugeVector<MeanStep> steps;

  // Gives new vertices their values.
  void resize() { light.resize(table.size()), evidence.resize(table.size()), cuts.resize(table.size()); }
};

// All levels, by the exponent of their cells' edge.
class GridLevels {
 public:
  GridLevel& operator[](int l) { return *levels_[l - kLeast]; }
  const GridLevel& operator[](int l) const { return *levels_[l - kLeast]; }
  static bool has(int l) { return l >= kLeast && l <= kMost; }
  // nullptr where there is none.
  const GridLevel* find(int l) const { return has(l) ? levels_[l - kLeast].get() : nullptr; }
  // Makes those of [first, last] that do not exist.
  void makeAll(int first, int last) {
    SACCADE_CHECK(has(first) && has(last));
    for (int l = first; l <= last; ++l)
      if (!levels_[l - kLeast]) levels_[l - kLeast] = std::make_unique<GridLevel>();
  }
  // f(the exponent, the level), from fine to coarse.
  void forEach(const auto& f) { forEach(*this, f); }
  void forEach(const auto& f) const { forEach(*this, f); }

 private:
  static void forEach(auto& levels, const auto& f) {
    for (int l = kLeast; l <= kMost; ++l)
      if (levels.levels_[l - kLeast]) f(l, levels[l]);
  }

  static constexpr int kLeast = -64, kMost = 63;
  std::array<std::unique_ptr<GridLevel>, kMost - kLeast + 1> levels_;
};

// The weighted sum over a pixel's taps in one slot.
template <class V>
V gather(const HugeVector<V>& values, const Placement& at, const GridPoint& p, int slot) {
  V sum{};
  for (std::uint32_t t = p.first; t < p.first + p.count; ++t) {
    const Taps& taps = at.taps[slot][t];
    for (int i = 0; i < 4; ++i) sum += values[taps.vertex[i]] * taps.weight[i];
  }
  return sum;
}

// Adds a sample to the vertices of a pixel in one slot, where `open` says that a vertex takes more.
template <class V, class Open>
void scatter(const V& sample, const Placement& at, const GridPoint& p, int slot, HugeVector<V>& sums,
             const Open& open) {
  for (std::uint32_t t = p.first; t < p.first + p.count; ++t) {
    const Taps& taps = at.taps[slot][t];
    for (int i = 0; i < 4; ++i) {
      V& sum = sums[taps.vertex[i]];
      if (open(sum)) sum += sample * taps.weight[i];
    }
  }
}

}  // namespace saccade
