// Compares two pictures of one view by their means over square blocks. Noise and different pixel filters
// average out.
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
  double least_light = 0.1;              // skips blocks darker than this share of the median block
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

// Leaves out incomplete blocks at the right and the bottom, and blocks with a value that is not finite. The
// picture has the size of the reference, or is smaller by a factor that leaves blocks of whole pixels.
// Otherwise, and with nothing to compare, throws std::runtime_error.
BlockRatios blockRatios(const RgbPlanes& picture, const RgbPlanes& reference, const BlockSettings& settings);

}  // namespace saccade::eval
