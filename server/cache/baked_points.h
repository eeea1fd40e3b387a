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
  using F = Floats<kMost>;
  struct Point {
    int x, y;             // of the pixel
    std::uint32_t index;  // SurfaceSamples::indexOf()
  };
  // What the vertices around each point say, by BakedLane, on both of its levels.
  using Light = std::array<F, 8>;

  int count() const { return count_; }
  bool full() const { return count_ == kMost; }
  const Point& operator[](int i) const { return points_[i]; }

  void clear() { count_ = 0; }
  void add(const Point& point, const SurfacePlace& place, SurfaceKind kind) {
    for (TetrahedronLanes& lanes : tetrahedra_) lanes.setPoint(count_, place.position);
    normal_[0][count_] = place.normal.x, normal_[1][count_] = place.normal.y,
    normal_[2][count_] = place.normal.z;
    footprint_[count_] = place.footprint;
    first_bin_[count_] = vertexBin(0, kind);
    points_[count_++] = point;
  }

  // Splits the edge of cells into level and scale as gridPoint() does. `finest_px`: edge of the finest cells,
  // pixels.
  void want(const BakedLevels& levels, float finest_px) {
    const Uints<kMost> bits = std::bit_cast<Uints<kMost>>(F(finest_px * load<kMost>(footprint_)));
    constexpr std::uint32_t kExponent = 0x7f800000, kOne = 0x3f800000;
    scale_ = std::bit_cast<F>(Uints<kMost>((bits & ~kExponent) | kOne));
    F edge = std::bit_cast<F>(Uints<kMost>(bits & kExponent));
    for (TetrahedronLanes& lanes : tetrahedra_) lanes.find(1.f / edge), edge *= 2.f;
    alignas(64) std::uint32_t level[kMost];
    store(Uints<kMost>(bits >> 23), level);
    findBins();
    taps_end_ = 0;
    for (int i = 0; i < count_; ++i) {
      const Bins bins = binsOf(i);
      for (int slot = 0; slot < kSlotsRead; ++slot) {
        Group& group = groups_[slot][i];
        group.level = levels.find(static_cast<int>(level[i]) - 127 + slot);
        group.first = taps_end_;
        if (group.level) want(*group.level, bins, slot, i);
        group.end = taps_end_;
      }
    }
  }
  void find() {
    for (int slot = 0; slot < kSlotsRead; ++slot)
      for (int i = 0; i < count_; ++i) find(slot, i);
  }
  Light light(int slot) const {
    std::array<Octet, kMost> sums{};
    for (int i = 0; i < count_; ++i) {
      const auto [level, first, end] = groups_[slot][i];
      for (int t = first; t < end; ++t)
        for (int c = 0; c < 4; ++c) sums[i] += (*level)[taps_[t].light[c]].light() * taps_[t].weights[c];
    }
    Light light;
    const auto columns = transposed(sums);
    for (int k = 0; k < kMost; ++k) light[k] = F(columns[k]);
    return light;
  }
  // Edge of a pixel's finest cells over that of its finer level, [1, 2).
  const F& scale() const { return scale_; }
  // log2 of it to 4e-4, exact at both ends.
  F fraction() const {
    const F t = scale_ - 1.f;
    return t + t * (1.f - t) * (0.4427f + t * (t * 0.0833f - 0.2473f));
  }

 private:
  static constexpr int kSlotsRead = 2;
  struct Tap {  // a tetrahedron of one bin
    BakedLevel::Place at;
    float share;  // of the point's weights
    BakedLevel::Indices light;
    Quad weights;  // of known corners
  };
  struct Group {  // the taps of one point in one slot
    const BakedLevel* level;
    int first, end;
  };

  // As NormalBins.
  void findBins() {
    std::array<F, 3> n, w;
    for (int k = 0; k < 3; ++k) n[k] = load<kMost>(normal_[k]), w[k] = n[k] * n[k] * n[k] * n[k];
    const F inv = 1.f / (w[0] + w[1] + w[2]);
    for (F& share : w) share = max(F(0.f), F(share * inv - NormalBins::kLeastShare));
    const F to_one = 1.f / (w[0] + w[1] + w[2]);
    for (int k = 0; k < 3; ++k) store(F(w[k] * to_one), bin_share_[k]);
  }
  struct Bins {
    int count = 0;
    std::array<int, 3> bin;
    std::array<float, 3> share;
  };
  Bins binsOf(int i) const {
    Bins bins;
    for (int k = 0; k < 3; ++k) {
      if (bin_share_[k][i] <= 0) continue;
      bins.bin[bins.count] = first_bin_[i] + k + (normal_[k][i] < 0 ? 3 : 0);
      bins.share[bins.count++] = bin_share_[k][i];
    }
    return bins;
  }
  void want(const BakedLevel& level, const Bins& bins, int slot, int i) {
    for (int b = 0; b < bins.count; ++b) {
      Tap& tap = taps_[taps_end_++];
      tap.at = level.prefetch(tetrahedra_[slot].lowest(i, bins.bin[b]));
      tap.share = bins.share[b];
    }
  }
  void find(int slot, int i) {
    const auto [level, first, end] = groups_[slot][i];
    for (int t = first; t < end; ++t) {
      Tap& tap = taps_[t];
      tap.light = level->find(tap.at, tetrahedra_[slot].order(i));
      for (const std::uint32_t index : tap.light) __builtin_prefetch(&(*level)[index]);
      const __m128i nothing =
          _mm_cmpeq_epi32(std::bit_cast<__m128i>(tap.light), _mm_set1_epi32(BakedLevel::kNothing));
      tap.weights = _mm_andnot_ps(_mm_castsi128_ps(nothing), tetrahedra_[slot].weights(i) * tap.share);
    }
  }

  int count_ = 0, taps_end_ = 0;
  std::array<Point, kMost> points_;
  alignas(64) float normal_[3][kMost] = {};
  alignas(64) float footprint_[kMost] = {};
  alignas(64) float bin_share_[3][kMost];
  int first_bin_[kMost];
  F scale_ = 1.f;
  std::array<std::array<Group, kMost>, kSlotsRead> groups_;
  std::array<Tap, kSlotsRead * kMost * 3> taps_;
  std::array<TetrahedronLanes, kSlotsRead> tetrahedra_;
};

}  // namespace saccade
