// The bins of several points' normals at once: what NormalBins finds for each.
#pragma once

#include "base/wide.h"
#include "cache/lattice/lattice.h"

namespace saccade {

// A list of the bins of all points: first each point's largest one, in the order of points, then all others.
class BinLanes {
 public:
  static constexpr int kLanes = 8;
  static constexpr int kMostBins = 3 * kLanes;
  using F = Floats<kLanes>;
  using U = Uints<kLanes>;

  // `first`: the bin of vertices for bin 0 of normals.
  void setPoint(int lane, Vec3 normal, int first) {
    normal_[0][lane] = normal.x, normal_[1][lane] = normal.y, normal_[2][lane] = normal.z;
    first_[lane] = static_cast<std::uint32_t>(first);
  }
  // Of the points that have been set, `count` of them.
  void find(int count) {
    std::array<F, 3> n, w;
    std::array<U, 3> bin;
    for (unsigned k = 0; k < 3; ++k) {
      n[k] = load<kLanes>(normal_[k]), w[k] = n[k] * n[k] * n[k] * n[k];
      bin[k] = load<kLanes>(first_) + k + 3u * (std::bit_cast<U>(n[k]) >> 31);
    }
    const F inv = 1.f / (w[0] + w[1] + w[2]);
    for (F& share : w) share = max(F(0.f), F(share * inv - NormalBins::kLeastShare));
    const F to_one = 1.f / (w[0] + w[1] + w[2]);
    for (F& share : w) share *= to_one;
    const auto x = w[0] >= w[1] && w[0] >= w[2], y = !x && w[1] >= w[2], z = !x && !y;  // is the largest
    store(laneNumbers<kLanes>(), point_);
    store(toUints(select(x, toFloats(bin[0]), select(y, toFloats(bin[1]), toFloats(bin[2])))), bin_);
    store(select(x, w[0], select(y, w[1], w[2])), share_);
    size_ = count;
    addOthers(lanesOf(w[0] > 0.f && !x), bin[0], w[0], count);
    addOthers(lanesOf(w[1] > 0.f && !y), bin[1], w[1], count);
    addOthers(lanesOf(w[2] > 0.f && !z), bin[2], w[2], count);
  }

  int size() const { return size_; }
  int point(int i) const { return static_cast<int>(point_[i]); }
  int bin(int i) const { return static_cast<int>(bin_[i]); }
  float share(int i) const { return share_[i]; }  // of the point's weights

 private:
  void addOthers(LaneSet lanes, const U& bin, const F& share, int count) {
    lanes &= LaneSet::first(count);
    compress(lanes, laneNumbers<kLanes>(), &point_[size_]);
    compress(lanes, bin, &bin_[size_]);
    compress(lanes, share, &share_[size_]);
    size_ += lanes.size();
  }

  alignas(64) float normal_[3][kLanes] = {};
  alignas(64) std::uint32_t first_[kLanes] = {};
  int size_ = 0;
  // compress() may overwrite lanes beyond the last one.
  alignas(64) std::uint32_t point_[kMostBins + kLanes];
  alignas(64) std::uint32_t bin_[kMostBins + kLanes];
  alignas(64) float share_[kMostBins + kLanes];
};

}  // namespace saccade
