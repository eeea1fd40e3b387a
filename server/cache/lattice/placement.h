// The vertices around every surface point of a frame, on all levels that it takes part in.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "cache/lattice/lanes.h"
#include "cache/lattice/lattice.h"
#include "frame/surface_samples.h"

namespace saccade {

inline constexpr int kGridLevels = 6;  // that an estimate blends
inline constexpr int kPoolSteps = 2;   // evidence for a level is pooled that many levels up
inline constexpr int kSlots = kGridLevels - 1 + kPoolSteps;  // levels of a point; slot 0 is the finest

// A surface point's place in the grid.
struct GridPoint {
  std::uint32_t index = 0;  // of the point, SurfaceSamples::indexOf()
  std::int32_t level = 0;   // of slot 0
  float fraction = 0;       // of the way to the next level, [0, 1)
  float scale = 1;          // 2^fraction
  Vec3 position;
  std::uint32_t first = 0, count = 0;  // its taps, in each slot
  static bool isSlot(int slot) { return slot >= 0 && slot < kSlots; }
};

// The place of a point, without taps. `cell_px`: edge of the finest cells, pixels.
GridPoint gridPoint(const SurfacePlace& place, float cell_px);
inline constexpr int kVertexBins = 12;  // and as many for each further side of a cut
// The vertex on a side of the cut of one on side 0.
inline VertexKey onSide(VertexKey vertex, std::uint32_t side) {
  return vertex + (VertexKey{kVertexBins * side} << vertex_bits::kBin);
}
inline bool isOnFurtherSide(VertexKey vertex) {
  return Tetrahedron::binOf(vertex) >= kVertexBins;
}
// The bin of vertices for one of a normal's.
inline int vertexBin(int bin_of_normal, SurfaceKind kind) {
  constexpr int kMixed = kVertexBins / 2;
  return bin_of_normal + (kind == SurfaceKind::kMixed ? kMixed : 0);
}

// Four vertices of one bin.
struct Taps {
  std::array<std::uint32_t, 4> vertex;
  std::array<float, 4> weight;  // of all taps of a point in a slot the sum is 1
};

struct Placement {
  // Takes the points of a frame that can share light, and whose light is not known ahead. Fills all but
  // `taps`. `cell_px`: edge of the finest cells, pixels.
  void place(const SurfaceSamples& on, float cell_px);
  // Takes no points, and then single ones. `index`: GridPoint::index.
  void clear();
  void add(const SurfacePlace& place, SurfaceKind kind, std::uint32_t index, float cell_px);
  // Makes room for the taps of all points.
  void makeTaps();

  // The share of a point's own sample in what it gathers in a slot.
  float ownShare(const GridPoint& p, int slot) const {
    float sum = 0;
    for (std::uint32_t t = p.first; t < p.first + p.count; ++t)
      for (const float w : taps[slot][t].weight) sum += w * w;
    return sum;
  }
  bool empty() const { return points.empty(); }
  // The points of a band of kBandRows rows: first and last + 1.
  std::pair<std::size_t, std::size_t> ofBand(int band) const {
    return {band_ends[band], band_ends[band + 1]};
  }

  std::vector<GridPoint> points;       // band by band, and by squares within: neighbours share vertices
  std::vector<std::size_t> band_ends;  // their number up to each band; the first is 0
  std::vector<int> bins;               // of each tap
  std::vector<float> bin_weights;      // likewise
  std::array<std::vector<Taps>, kSlots> taps;  // by slot
  int least_level = 0, most_level = -1;        // of any slot
};

}  // namespace saccade
