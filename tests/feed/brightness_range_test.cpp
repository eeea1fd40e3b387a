#include "feed/brightness_range.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/hash_rng.h"

namespace saccade {
namespace {

constexpr int kW = 70, kH = 41;

float randomAt(std::uint64_t seed, int x, int y) {
  return toUnit(hashKey(hashKey(seed, static_cast<std::uint64_t>(x)), static_cast<std::uint64_t>(y)));
}

// Against the range of each square by itself.
TEST(BrightnessRange, IsThatOfASquareAtBothEnds) {
  ImageF a(kW, kH), b(kW, kH);
  for (int y = 0; y < kH; ++y)
    for (int x = 0; x < kW; ++x) {
      a.at(x, y) = randomAt(1, x / 3, y / 3);
      b.at(x, y) = randomAt(2, x / 3, y / 3);
    }
  constexpr float kLimit = 0.7f;
  for (const int reach : {1, 3, kMostReach}) {
    for (const Tile tile : {Tile{0, 0, 32, 32}, Tile{64, 32, kW, kH}}) {
      TileRanges ranges;
      ranges.find(a, b, tile, reach);
      const TileMask mask = ranges.above(kLimit);
      int marked = 0;
      for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x) {
          float low = 1, high = 0;
          for (int j = std::max(0, y - reach); j <= std::min(kH - 1, y + reach); ++j)
            for (int i = std::max(0, x - reach); i <= std::min(kW - 1, x + reach); ++i)
              for (const ImageF* plane : {&a, &b})
                low = std::min(low, plane->at(i, j)), high = std::max(high, plane->at(i, j));
          const bool is_marked = (mask[static_cast<std::size_t>(y - tile.y0)] >> (x - tile.x0) & 1) != 0;
          ASSERT_EQ(is_marked, high - low > kLimit) << x << " " << y << " " << reach;
          marked += is_marked;
        }
      EXPECT_GT(marked, 0);
    }
  }
}

TEST(BrightnessRange, MarksNothingInAnEvenPicture) {
  ImageF even(kW, kH);
  even.fill(3);
  TileRanges ranges;
  ranges.find(even, even, {0, 0, 32, 32}, 2);
  for (const std::uint32_t row : ranges.above(0)) EXPECT_EQ(row, 0u);
}

}  // namespace
}  // namespace saccade
