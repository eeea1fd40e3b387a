// Where brightness can change within an interval: around edges and textures, as far as the picture moves.
#pragma once

#include <array>

#include "base/pool_handle.h"
#include "frame/image.h"

namespace saccade {

inline constexpr int kRefinedTile = 32;  // edge, pixels
inline constexpr int kMostReach = 16;    // pixels: a picture that moves further has no more reach
using TileMask = std::array<std::uint32_t, kRefinedTile>;  // a bit for each pixel of a row

// Ranges of log brightness around the pixels of a tile.
class TileRanges {
 public:
  // Both ends of the interval count together, in squares that end `reach` pixels away, at most kMostReach, or
  // at the picture's edge. The tile has an edge of at most kRefinedTile.
  void find(const ImageF& at_t0, const ImageF& at_t1, Tile tile, int reach);
  // Marks the pixels whose range is more than `limit`.
  TileMask above(float limit) const;

 private:
  int width_ = 0, height_ = 0;  // of the tile
  std::array<std::array<float, kRefinedTile>, kRefinedTile> of_;
};

}  // namespace saccade
