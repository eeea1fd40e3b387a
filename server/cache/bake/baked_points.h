// A few points on their way through a bake: their vertices are wanted, located, found and read. Between these
// steps what the next one needs comes from memory.
#pragma once

#include "cache/bake/baked_levels.h"
#include "cache/lattice/bin_lanes.h"
#include "cache/lattice/placement.h"
#include "cache/lattice/tetrahedron_lanes.h"

namespace saccade {

class BakedPoints {
 public:
  static constexpr int kMost = TetrahedronLanes::kLanes;
  static_assert(kMost == BinLanes::kLanes);
  using F = Floats<kMost>;
  struct Point {
    int x, y;             // of the pixel
    std::uint32_t index;  // SurfaceSamples::indexOf()
  };

  int count() const { return count_; }
  bool full() const { return count_ == kMost; }
  const Point& operator[](int i) const { return points_[i]; }

  void clear() { count_ = 0; }
  void add(const Point& point, const SurfacePlace& place, SurfaceKind kind) {
    tetrahedra_.setPoint(count_, place.position);
    taps_.setPoint(count_, place.normal, vertexBin(0, kind));
    footprint_[count_] = place.footprint;
    points_[count_++] = point;
  }

  // Splits the edge of cells into level and scale as gridPoint() does. `cell_px`: edge of the finest cells,
  // pixels.
  void want(const BakedLevels& levels, float cell_px) {
    const Uints<kMost> bits = std::bit_cast<Uints<kMost>>(F(cell_px * load<kMost>(footprint_)));
    constexpr std::uint32_t kExponent = 0x7f800000, kOne = 0x3f800000;
    scale_ = std::bit_cast<F>(Uints<kMost>((bits & ~kExponent) | kOne));
    tetrahedra_.find(1.f / std::bit_cast<F>(Uints<kMost>(bits & kExponent)));
    taps_.find(count_);
    alignas(64) std::uint32_t exponent[kMost];
    store(Uints<kMost>(bits >> 23), exponent);
    for (int i = 0; i < count_; ++i) levels_[i] = levels.from(static_cast<int>(exponent[i]) - 127);
    for (int t = 0; t < taps_.size(); ++t) {
      const int i = taps_.point(t);
      levels_[i].fine->prefetch(tetrahedra_.lowest(i, taps_.bin(t)));
    }
  }
  void locate() {
    for (int t = 0; t < taps_.size(); ++t) {
      const int i = taps_.point(t);
      places_[t] = levels_[i].fine->locate(tetrahedra_.lowest(i, taps_.bin(t)));
    }
  }
  void find() {
    for (int t = 0; t < taps_.size(); ++t) {
      const int i = taps_.point(t);
      const BakedLevel& level = *levels_[i].fine;
      indices_[t] = level.find(places_[t], tetrahedra_.order(i));
      for (const std::uint32_t index : indices_[t]) __builtin_prefetch(&level[index]);
      if (BakedLevel::lacks(indices_[t])) levels_[i].coarse->prefetch(coarseCorners(t).key[0]);
    }
  }
  // Sums over the vertices around each point: the columns of BakedSums.
  struct Light {
    std::array<Octet, kMost> means, variances;
  };
  Light light() const {
    Light rows;
    for (int t = 0; t < taps_.size(); ++t) {
      const BakedSums sum = read(t);
      Octet &means = rows.means[taps_.point(t)], &variances = rows.variances[taps_.point(t)];
      means = t < count_ ? sum.means : means + sum.means;
      variances = t < count_ ? sum.variances : variances + sum.variances;
    }
    return {transposed(rows.means), transposed(rows.variances)};
  }
  // Whether shadows() is above 0 at any point.
  bool anyNearShadow() const {
    for (int t = 0; t < taps_.size(); ++t) {
      const BakedLevels::Two& levels = levels_[taps_.point(t)];
      if (levels.fine->isNearShadow(places_[t])) return true;
      if (levels.coarse->hasShadows() && BakedLevel::lacks(indices_[t])) return true;
    }
    return false;
  }
  // BakedVertex::shadow around each point: of its finer level, or of the coarser one where that has gaps.
  F shadows() const {
    alignas(64) float of_points[kMost] = {};
    for (int t = 0; t < taps_.size(); ++t) of_points[taps_.point(t)] += taps_.share(t) * shadowAround(t);
    return load<kMost>(of_points);
  }
  // Edge of a pixel's finest cells over that of its finer level, [1, 2).
  const F& scale() const { return scale_; }
  // log2 of it to 4e-4, exact at both ends.
  F fraction() const {
    const F t = scale_ - 1.f;
    return t + t * (1.f - t) * (0.4427f + t * (t * 0.0833f - 0.2473f));
  }

 private:
  static constexpr float kNearlyOne = 1 - 1e-4f;  // what is missing beyond rounding shows nowhere

  Tetrahedron coarseCorners(int tap) const {
    const int i = taps_.point(tap);
    const double per_edge = powerOfTwo(std::max(-levels_[i].exponent - 1, -126));
    return {toDouble(tetrahedra_.point(i)) * per_edge, taps_.bin(tap)};
  }
  // Sums over the corners of a tap.
  BakedSums read(int tap) const {
    const int i = taps_.point(tap);
    const Quad weights = tetrahedra_.weights(i) * taps_.share(tap);
    BakedSums sum;
    for (int c = 0; c < 4; ++c) sum.add((*levels_[i].fine)[indices_[tap][c]], Octet{} + weights[c]);
    const bool all_coarse = sum.means[kOfCoarse + kKnown] > kNearlyOne * taps_.share(tap);
    return all_coarse ? sum : readApart(tap);
  }
  float shadowAround(int tap) const {
    const auto& [fine, coarse, exponent] = levels_[taps_.point(tap)];
    float sum = 0;
    if (BakedLevel::lacks(indices_[tap])) {
      const Tetrahedron corners = coarseCorners(tap);
      for (int c = 0; c < 4; ++c) sum += corners.weight[c] * coarse->shadowAt(corners.key[c]);
    } else if (fine->isNearShadow(places_[tap])) {
      const Quad weights = tetrahedra_.weights(taps_.point(tap));
      for (int c = 0; c < 4; ++c) sum += weights[c] * fine->shadow(indices_[tap][c]);
    }
    return sum;
  }
  // Where not all corners know the coarser light: what each level knows by itself.
  [[gnu::noinline]] BakedSums readApart(int tap) const {
    const int i = taps_.point(tap);
    const float share = taps_.share(tap);
    const Tetrahedron coarse = coarseCorners(tap);
    const Quad weights = tetrahedra_.weights(i) * share;
    BakedSums sum;
    for (int c = 0; c < 4; ++c) {
      const float w = weights[c], v = coarse.weight[c] * share;
      sum.add(BakedPair::ofFine((*levels_[i].fine)[indices_[tap][c]], levels_[i].coarse->at(coarse.key[c])),
              Octet{w, w, w, w, v, v, v, v});
    }
    return sum;
  }

  int count_ = 0;
  std::array<Point, kMost> points_;
  alignas(64) float footprint_[kMost] = {1, 1, 1, 1, 1, 1, 1, 1};  // lanes without a point have a valid one
  F scale_ = 1.f;
  std::array<BakedLevels::Two, kMost> levels_;  // of each point
  TetrahedronLanes tetrahedra_;
  BinLanes taps_;  // a tap is a tetrahedron of one bin
  std::array<BakedLevel::Place, BinLanes::kMostBins> places_;
  std::array<BakedLevel::Indices, BinLanes::kMostBins> indices_;
};

}  // namespace saccade
