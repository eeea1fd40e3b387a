// A few points on their way through a bake: their vertices are wanted, then found, then read. Between these
// steps what the next one needs comes from memory.
#pragma once

#include "cache/baked_level.h"
#include "cache/placement.h"
#include "cache/tetrahedron_lanes.h"

namespace saccade {

// The levels of a bake, from fine to coarse.
struct BakedLevels {
  const BakedLevel* find(int exponent) const {
    const int i = exponent - first;
    return i >= 0 && i < static_cast<int>(levels.size()) ? &levels[i] : nullptr;
  }

  int first = 0;  // the exponent of the finest
  std::vector<BakedLevel> levels;
};

class BakedPoints {
 public:
  static constexpr int kMost = TetrahedronLanes::kLanes;
  struct Point {
    int x, y;  // of the pixel
    SurfaceKind kind;
    GridPoint at;
    NormalBins bins;
  };

  int count() const { return count_; }
  bool full() const { return count_ == kMost; }
  const Point& operator[](int i) const { return points_[i]; }

  void clear() { count_ = 0; }
  // The point of pixel (x, y) with this index.
  void add(const SurfaceSamples& on, std::size_t index, int x, int y, float finest_px) {
    const SurfacePlace& place = on.place(index);
    points_[count_] = {x, y, on[index].kind, gridPoint(place, finest_px), NormalBins(place.normal)};
    points_[count_++].at.index = static_cast<std::uint32_t>(index);
  }
  void want(const BakedLevels& levels) {
    taps_end_ = 0;
    for (int slot = 0; slot < kSlotsRead; ++slot) {
      findTetrahedra(slot);
      for (int i = 0; i < count_; ++i) {
        Group& group = groups_[slot][i];
        group.level = levels.find(points_[i].at.level + slot);
        group.first = taps_end_;
        if (group.level) want(*group.level, i);
        group.end = taps_end_;
      }
    }
  }
  void find() {
    for (auto& groups : groups_)
      for (int i = 0; i < count_; ++i)
        for (int t = groups[i].first; t < groups[i].end; ++t) {
          taps_[t].light = groups[i].level->find(taps_[t].keys);
          for (int c = 0; c < 4; ++c) {
            if (!taps_[t].light[c]) taps_[t].light[c] = &kNothing, taps_[t].weights[c] = 0;
            __builtin_prefetch(taps_[t].light[c]);
          }
        }
  }
  // The weighted sum over the vertices around point i whose light is known.
  Octet sum(int slot, int i) const {
    Octet sum{};
    for (int t = groups_[slot][i].first; t < groups_[slot][i].end; ++t)
      for (int c = 0; c < 4; ++c) sum += taps_[t].light[c]->light() * taps_[t].weights[c];
    return sum;
  }

 private:
  static constexpr int kSlotsRead = 2;
  static constexpr BakedVertex kNothing{};
  struct Tap {  // a tetrahedron of one bin
    std::array<VertexKey, 4> keys;
    std::array<const BakedVertex*, 4> light;
    std::array<float, 4> weights;
  };
  struct Group {  // the taps of one point in one slot
    const BakedLevel* level;
    int first, end;
  };

  void findTetrahedra(int slot) {
    alignas(64) float inv_h[kMost] = {};
    for (int i = 0; i < count_; ++i) {
      lanes_.setPoint(i, points_[i].at.position);
      inv_h[i] = powerOfTwo(-points_[i].at.level - slot);
    }
    lanes_.find(load<kMost>(inv_h));
  }
  void want(const BakedLevel& level, int i) {
    const NormalBins& bins = points_[i].bins;
    for (int b = 0; b < bins.count; ++b) {
      const int bin = vertexBin(bins.bin[b], points_[i].kind);
      Tap& tap = taps_[taps_end_++];
      tap.keys = Tetrahedron::corners(lanes_.lowest(i, bin), lanes_.order(i));
      level.prefetch(tap.keys[0]), level.prefetch(tap.keys[3]);
      for (int c = 0; c < 4; ++c) tap.weights[c] = bins.weight[b] * lanes_.weight(i, c);
    }
  }

  int count_ = 0, taps_end_ = 0;
  std::array<Point, kMost> points_;
  std::array<std::array<Group, kMost>, kSlotsRead> groups_;
  std::array<Tap, kSlotsRead * kMost * 3> taps_;
  TetrahedronLanes lanes_;
};

}  // namespace saccade
