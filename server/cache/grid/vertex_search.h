// Finds the vertices around the points of a frame on one level, and adds those that are missing. Walls are
// for CutSearch, where vertices are new.
#pragma once

#include "cache/grid/grid_levels.h"
#include "cache/grid/new_vertices.h"
#include "cache/lattice/tetrahedron_lanes.h"

namespace saccade {

class VertexSearch {
 public:
  // Sets the taps of `at` that add() is called for. `l`: the exponent of the level. `now`: the frame. Adds to
  // `found`.
  VertexSearch(GridLevel& level, int l, std::uint32_t now, Placement& at, NewVertices& found)
      : table_(level.table),
        cuts_(level.cuts),
        first_new_(table_.size()),
        finder_(level.table, now),
        at_(at),
        found_(found),
        inv_h_(std::ldexp(1.f, -l)) {}

  void add(const GridPoint& p, int slot) {
    lanes_.setPoint(waiting_, p.position);
    points_[waiting_++] = {&p, slot};
    if (waiting_ == TetrahedronLanes::kLanes) findAll();
  }
  void finish() {
    findAll();
    for (std::uint32_t i = count_ > kOnTheWay ? count_ - kOnTheWay : 0; i < count_; ++i)
      finish(waiting_taps_[i % kOnTheWay]);
    count_ = 0;
  }

 private:
  struct Found {
    std::array<VertexTable::Place, 4> places;
    VertexKey lowest = 0;
    unsigned order = 0;
    Taps* taps = nullptr;
    bool same = false;  // the tetrahedron as of the last one in its bin
    NewVertices::Tap of{};
    int bin = 0;
  };
  // Of a tetrahedron.
  struct Corners {
    Indices vertices;
    bool any_new, are_cut;
    CutTaps cut;
  };
  struct Last {
    VertexKey lowest = 0;
    unsigned order = 0;
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
    Found& f = waiting_taps_[count_ % kOnTheWay];
    if (count_++ >= kOnTheWay) finish(f);
    f.of = {static_cast<std::uint32_t>(points_[lane].first - at_.points.data()), t}, f.bin = bin;
    f.taps = &at_.taps[slot][t];
    f.taps->weight = std::bit_cast<std::array<float, 4>>(lanes_.weights(lane) * at_.bin_weights[t]);
    const VertexKey lowest = lanes_.lowest(lane, bin);
    const unsigned order = lanes_.order(lane);
    Last& before = last_[bin];
    f.same = before.lowest == lowest && before.order == order;
    before = {lowest, order};
    if (f.same) return;
    f.lowest = lowest, f.order = order;
    const auto keys = Tetrahedron::corners(lowest, order);
    for (int c = 0; c < 4; ++c) f.places[c] = finder_.find(keys[c]);
  }
  [[gnu::always_inline]] void finish(const Found& f) {
    Corners& corners = corners_[f.bin];
    if (!f.same) findCorners(f, corners);
    const Indices v = corners.are_cut ? corners.cut.of(at_.points[f.of.point].position) : corners.vertices;
    f.taps->vertex = std::bit_cast<std::array<std::uint32_t, 4>>(v);
    if (corners.any_new) [[unlikely]]
      found_.taps.push_back(f.of);
  }
  [[gnu::always_inline]] void findCorners(const Found& f, Corners& out) {
    const std::uint32_t known = table_.size();
    const auto vertex = [&](int c) { return table_.markedIndexAt(f.places[c]); };
    const std::uint32_t a = vertex(0), b = vertex(1), c = vertex(2), d = vertex(3);
    out.vertices = Indices{a, b, c, d};
    out.any_new = out.are_cut = false;
    if (((a | b | c | d) & VertexTable::kMarked) != 0) lookAtMarked(f, known, out);
  }
  // Some are new, or have a cut.
  [[gnu::noinline]] void lookAtMarked(const Found& f, std::uint32_t known, Corners& out) {
    Indices& v = out.vertices;
    v &= ~VertexTable::kMarked;
    const auto keys = Tetrahedron::corners(f.lowest, f.order);
    for (int c = 0; c < 4; ++c) {
      if (v[c] >= known) found_.vertices.push_back({keys[c], f.places[c], v[c], f.of.point});
      out.any_new |= v[c] >= first_new_;
    }
    out.are_cut = !out.any_new;
    if (out.are_cut) out.cut = CutTaps(cuts_, v);
  }

  VertexTable& table_;
  const Cuts& cuts_;
  const std::uint32_t first_new_;
  VertexTable::Finder finder_;
  Placement& at_;
  NewVertices& found_;
  float inv_h_;
  TetrahedronLanes lanes_;
  std::array<std::pair<const GridPoint*, int>, TetrahedronLanes::kLanes> points_;
  int waiting_ = 0;
  std::array<Found, kOnTheWay> waiting_taps_{};
  std::uint32_t count_ = 0;
  std::array<Last, kVertexBins> last_{};      // of each bin
  std::array<Corners, kVertexBins> corners_;  // of the last one that was finished, likewise
};

}  // namespace saccade
