// Finds the vertices around the points of a frame on one level, and adds those that are missing.
#pragma once

#include "cache/grid_levels.h"
#include "cache/tetrahedron_lanes.h"

namespace saccade {

class VertexSearch {
 public:
  // Sets the taps of `at` that add() is called for. `l`: the exponent of the level. `now`: the frame.
  VertexSearch(GridLevel& level, int l, std::uint32_t now, Placement& at)
      : table_(level.table), finder_(level.table, now), at_(at), inv_h_(std::ldexp(1.f, -l)) {}

  void add(const GridPoint& p, int slot) {
    lanes_.setPoint(waiting_, p.position);
    points_[waiting_++] = {&p, slot};
    if (waiting_ == TetrahedronLanes::kLanes) findAll();
  }
  void finish() {
    findAll();
    for (std::uint32_t i = count_ > kOnTheWay ? count_ - kOnTheWay : 0; i < count_; ++i)
      finish(found_[i % kOnTheWay]);
    count_ = 0;
  }

 private:
  struct Found {
    std::array<VertexTable::Place, 4> places;
    Taps* taps = nullptr;
    const Taps* same = nullptr;  // earlier taps in the same tetrahedron
  };
  struct Last {
    VertexKey lowest = 0;
    unsigned order = 0;
    const Taps* taps = nullptr;
  };
  static constexpr std::uint32_t kOnTheWay = 8;  // whose vertices are on their way from memory

  void findAll() {
    lanes_.find(inv_h_);
    for (int i = 0; i < waiting_; ++i) {
      const auto [p, slot] = points_[i];
      for (std::uint32_t t = p->first; t < p->first + p->count; ++t) find(i, at_.bins[t], t, slot);
    }
    waiting_ = 0;
  }
  void find(int lane, int bin, std::uint32_t t, int slot) {
    Found& f = found_[count_ % kOnTheWay];
    if (count_++ >= kOnTheWay) finish(f);
    f.taps = &at_.taps[slot][t];
    f.taps->weight = std::bit_cast<std::array<float, 4>>(lanes_.weights(lane) * at_.bin_weights[t]);
    const VertexKey lowest = lanes_.lowest(lane, bin);
    const unsigned order = lanes_.order(lane);
    Last& before = last_[bin];
    f.same = before.lowest == lowest && before.order == order ? before.taps : nullptr;
    before = {lowest, order, f.taps};
    if (f.same) return;
    const auto keys = Tetrahedron::corners(lowest, order);
    for (int c = 0; c < 4; ++c) f.places[c] = finder_.find(keys[c]);
  }
  void finish(const Found& f) {
    if (f.same) {
      f.taps->vertex = f.same->vertex;
      return;
    }
    for (int c = 0; c < 4; ++c) f.taps->vertex[c] = table_.indexAt(f.places[c]);
  }

  VertexTable& table_;
  VertexTable::Finder finder_;
  Placement& at_;
  float inv_h_;
  TetrahedronLanes lanes_;
  std::array<std::pair<const GridPoint*, int>, TetrahedronLanes::kLanes> points_;
  int waiting_ = 0;
  std::array<Found, kOnTheWay> found_{};
  std::uint32_t count_ = 0;
  std::array<Last, kVertexBins> last_{};  // of each bin
};

}  // namespace saccade
