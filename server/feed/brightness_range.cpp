#include "feed/brightness_range.h"

#include <algorithm>

#include "base/scratch.h"

namespace saccade {
namespace {

constexpr int kMostWide = kRefinedTile + 2 * kMostReach;
struct Extremes {
  std::array<float, kMostWide> low, high;
};

// The extremes over 2 * reach + 1 values that end at or surround each of `count`. `from` has its first value
// `reach` before them.
void slide(const Extremes& from, int reach, int count, Extremes& to) {
  std::copy_n(from.low.begin(), count, to.low.begin()),
      std::copy_n(from.high.begin(), count, to.high.begin());
  for (int shift = 1; shift <= 2 * reach; ++shift)
    for (int i = 0; i < count; ++i) {
      to.low[i] = std::min(to.low[i], from.low[i + shift]);
      to.high[i] = std::max(to.high[i], from.high[i + shift]);
    }
}

}  // namespace

void TileRanges::find(const ImageF& at_t0, const ImageF& at_t1, Tile tile, int reach) {
  const Scratch<std::array<Extremes, kMostWide>> rows;
  const int width = width_ = tile.x1 - tile.x0, height = height_ = tile.y1 - tile.y0;
  for (int j = 0; j < height + 2 * reach; ++j) {
    const int y = std::clamp(tile.y0 - reach + j, 0, at_t0.height() - 1);
    const float *a = at_t0.row(y), *b = at_t1.row(y);
    Extremes row;
    for (int i = 0; i < width + 2 * reach; ++i) {
      const int x = std::clamp(tile.x0 - reach + i, 0, at_t0.width() - 1);
      row.low[i] = std::min(a[x], b[x]), row.high[i] = std::max(a[x], b[x]);
    }
    slide(row, reach, width, (*rows)[j]);
  }
  for (int y = 0; y < height; ++y) {
    Extremes around = (*rows)[y];
    for (int j = y + 1; j <= y + 2 * reach; ++j)
      for (int x = 0; x < width; ++x) {
        around.low[x] = std::min(around.low[x], (*rows)[j].low[x]);
        around.high[x] = std::max(around.high[x], (*rows)[j].high[x]);
      }
    for (int x = 0; x < width; ++x) of_[y][x] = around.high[x] - around.low[x];
  }
}

TileMask TileRanges::above(float limit) const {
  TileMask mask{};
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) mask[y] |= std::uint32_t{of_[y][x] > limit} << x;
  return mask;
}

}  // namespace saccade
