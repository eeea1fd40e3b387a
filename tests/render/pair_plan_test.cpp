#include "render/tiles/pair_plan.h"

#include <gtest/gtest.h>

#include "base/hash_rng.h"
#include "base/tile_pool.h"

namespace saccade {
namespace {

constexpr int kW = 16, kH = 12;

struct PairPlanTest : testing::Test {
  // Pairs whose changes are apart by up to `noise`, and by a hundred times that in 2x2 pixels.
  PairPlanTest() {
    pairs.count.fill(1), now.g.albedo.fill(1), before.g.albedo.fill(1);
    for (int y = 0; y < kH; ++y)
      for (int x = 0; x < kW; ++x) {
        pairs.before.at(x, y) = 1;
        now.samples.I2.at(x, y) =
            1.f + 0.01f * (isNoisy(x, y) ? 100 : 1) * (toUnit(hashKey(1, y * kW + x)) - 0.5f);
      }
  }
  static bool isNoisy(int x, int y) { return (x == 7 || x == 8) && (y == 5 || y == 6); }

  TilePool pool{2};
  Frame now{kW, kH}, before{kW, kH};
  PairSamples pairs{kW, kH};
};

TEST_F(PairPlanTest, MorePairsGoWhereTheNoiseIs) {
  planMorePairs(now, before, pool, pairs);
  EXPECT_GT(pairs.more.at(7, 5), 0);
  EXPECT_GT(pairs.more.at(8, 6), 0);
  EXPECT_EQ(pairs.more.at(2, 5), 0);
  EXPECT_EQ(pairs.more.at(14, 6), 0);
  // Of evenly distributed numbers within 0.01: a twelfth of its square.
  EXPECT_NEAR(pairs.variance.at(2, 3), 1e-4 / 12, 0.6e-4 / 12);
}

TEST_F(PairPlanTest, TexturesAreNoNoise) {
  for (int y = 0; y < kH; ++y)
    for (int x = 0; x < kW; ++x) {
      now.samples.I2.at(x, y) = now.g.albedo.at(x, y) = x % 2 == 0 ? 0.25f : 0.5f;
      pairs.before.at(x, y) = before.g.albedo.at(x, y) = x % 2 == 0 ? 0.5f : 0.25f;
    }
  planMorePairs(now, before, pool, pairs);
  EXPECT_EQ(pairs.variance.at(7, 5), 0);
  EXPECT_EQ(pairs.more.at(7, 5), 0);
}

// As on thin rods.
TEST_F(PairPlanTest, PixelsWithoutNeighboursGetMore) {
  pairs.count.fill(0);
  pairs.more.fill(0);
  for (const auto& [x, y] : {std::pair{2, 3}, {10, 3}, {11, 3}}) pairs.count.at(x, y) = 1;
  now.samples.I2.at(10, 3) = now.samples.I2.at(11, 3) = 1;
  planMorePairs(now, before, pool, pairs);
  EXPECT_EQ(pairs.more.at(2, 3), 7);
  EXPECT_EQ(pairs.more.at(10, 3), 0);
  EXPECT_EQ(pairs.more.at(3, 3), 0);
}

TEST_F(PairPlanTest, PixelsWithoutPairsGetNone) {
  pairs.count.at(7, 5) = 0;
  pairs.more.fill(0);
  planMorePairs(now, before, pool, pairs);
  EXPECT_EQ(pairs.more.at(7, 5), 0);
  EXPECT_GT(pairs.more.at(8, 6), 0);
}

TEST_F(PairPlanTest, FurtherPairsJoinTheMeans) {
  now.samples.I2.at(1, 1) = 0.5f + 3, pairs.before.at(1, 1) = 0.25f + 1;
  now.g.emission.at(1, 1) = 0.5f, before.g.emission.at(1, 1) = 0.25f;
  now.g.albedo.at(1, 1) = 1, before.g.albedo.at(1, 1) = 0.5f;
  const std::array<std::array<float, 2>, 3> further{{{6, 2}, {9, 1.5f}, {6, 2.5f}}};
  addPairs(further, 1, 1, now.g, before.g, now.samples, pairs);
  EXPECT_EQ(pairs.count.at(1, 1), 4);
  EXPECT_FLOAT_EQ(now.samples.I2.at(1, 1), 0.5f + (3 + 6 + 9 + 6) / 4.f);
  EXPECT_FLOAT_EQ(pairs.before.at(1, 1), 0.25f + (1 + 2 + 1.5f + 2.5f) / 4.f);
  // Of changes of illumination: 2, 6 and 1, whose mean is 3.
  EXPECT_FLOAT_EQ(pairs.variance.at(1, 1), (1 + 9 + 4) / 2.f);
}

}  // namespace
}  // namespace saccade
