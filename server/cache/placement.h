// The vertices around every pixel's surface point, on all levels that it takes part in.
#pragma once

#include <array>
#include <vector>

#include "cache/lattice.h"
#include "frame/frame.h"

namespace saccade {

inline constexpr int kGridLevels = 7;  // that an estimate blends
inline constexpr int kPoolSteps = 2;   // evidence for a level is pooled that many levels up
inline constexpr int kSlots = kGridLevels - 1 + kPoolSteps;  // levels of a point; slot 0 is the finest

// A pixel's place in the grid.
struct GridPoint {
  Vec3 position;
  std::int32_t level = 0;   // of slot 0
  float fraction = 0;       // of the way to the next level, [0, 1)
  std::uint32_t first = 0;  // of its taps, in each slot
  std::uint32_t count = 0;  // of taps; 0: the pixel is not in the grid
  bool inSlot(int slot) const { return count > 0 && slot >= 0 && slot < kSlots; }
};

// The place of a pixel's surface, without taps. `finest_px`: edge of the finest cells, pixels.
GridPoint pointAt(const SurfaceSamples& on, int x, int y, float finest_px);
// The bin of vertices for one of a normal's.
inline int vertexBin(int bin_of_normal, SurfaceKind kind) {
  constexpr int kMixed = 6;
  return bin_of_normal + (kind == SurfaceKind::kMixed ? kMixed : 0);
}

// Four vertices of one bin.
struct Taps {
  std::array<std::uint32_t, 4> vertex;
  std::array<float, 4> weight;  // of all taps of a pixel in a slot the sum is 1
};

struct Placement {
  // Fills all but `taps`. Where `left_out` is not 0 a pixel is not in the grid; nullptr: nowhere.
  void place(const SurfaceSamples& on, const GBuffer& g, float finest_px,
             const Image<std::uint32_t>* left_out);

  // The share of a pixel's own sample in what it gathers in a slot.
  float ownShare(const GridPoint& p, int slot) const {
    float sum = 0;
    for (std::uint32_t t = p.first; t < p.first + p.count; ++t)
      for (const float w : taps[slot][t].weight) sum += w * w;
    return sum;
  }
  bool empty() const { return most_level < least_level; }

  std::vector<GridPoint> points;               // row-major
  std::vector<int> bins;                       // of each tap
  std::vector<float> bin_weights;              // likewise
  std::array<std::vector<Taps>, kSlots> taps;  // by slot
  int least_level = 0, most_level = -1;        // of any slot; most < least: no point is in the grid
};

}  // namespace saccade
