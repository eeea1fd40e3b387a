// Two pictures of one view, compared in the means over square blocks: where one of them is noisy, or pixels
// are filtered in another way.
#pragma once

#include <vector>

#include "base/vec.h"
#include "eval/metrics/rgb_planes.h"

namespace saccade::eval {

struct PixelRect {
  int x = 0, y = 0, width = 0, height = 0;
};

struct BlockSettings {
  int edge = 16;                         // of a block, pixels of the reference
  double least_light = 0.1;              // what is darker, as a part of the median block, is not compared
  std::vector<PixelRect> left_out = {};  // of the reference; blocks that they touch are not compared
};

struct Block {
  Rgb picture, reference;  // mean radiance
  bool compared;
  double ratio() const;  // of luminances, picture over reference
};

struct BlockRatios {
  int edge;  // of a block, pixels of the reference
  int across, down;
  std::vector<Block> blocks;  // row by row from the top

  int compared() const;
  std::array<double, 3> meanRatio() const;  // per channel: of the sums over the compared blocks
  double shareWithin(double within) const;  // of the compared blocks: ratio in [1 - within, 1 + within]
};

// What is left over at the right and the bottom is in no block; a block with a value that is no finite number
// is not compared. Throws std::runtime_error unless the picture has the reference's size or is smaller by a
// factor that a block of whole pixels remains, and if there is nothing to compare.
BlockRatios blockRatios(const RgbPlanes& picture, const RgbPlanes& reference, const BlockSettings& settings);

}  // namespace saccade::eval
