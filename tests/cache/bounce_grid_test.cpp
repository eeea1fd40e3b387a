#include "cache/grid/bounce_grid.h"

#include <gtest/gtest.h>

namespace saccade {
namespace {

constexpr float kPixel = 1.f / 16;  // cells of edge 1

BounceCell at(Vec3 point, Vec3 normal = {0, 0, 1}) {
  return BounceCell(point, normal, kPixel);
}

// Adds `count` samples of the light (red, 1, 1) in one cell.
void add(BounceGrid& grid, const BounceCell& cell, int count, float red = 1) {
  SurfaceSamples on(count, 1, 1);
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
    on[i].paths = 1, on.light(i).bounce = {cell.key, {red, 1, 1}};
  grid.add(on);
}

TEST(BounceCell, IsACubeWithASide) {
  const BounceCell cell = at({0.5f, 0.5f, 0.5f});
  EXPECT_EQ(cell.edge, 1);
  EXPECT_EQ(at({0.9f, 0.1f, 0.2f}, {0.2f, 0.1f, 0.9f}).key, cell.key);
  EXPECT_NE(at({1.1f, 0.5f, 0.5f}).key, cell.key);
  EXPECT_NE(at({-0.5f, 0.5f, 0.5f}).key, cell.key);
  EXPECT_NE(at({0.5f, 0.5f, 0.5f}, {0, 0, -1}).key, cell.key);
  EXPECT_NE(at({0.5f, 0.5f, 0.5f}, {1, 0, 0}).key, cell.key);
  EXPECT_NE(BounceCell({0.5f, 0.5f, 0.5f}, {0, 0, 1}, 2 * kPixel).key, cell.key);
}

TEST(BounceGrid, KnowsTheMeanOfEnoughSamples) {
  BounceGrid grid(100);
  const BounceCell cell = at({});
  add(grid, cell, 6, 1);
  EXPECT_FALSE(grid.find(cell));
  add(grid, cell, 18, 3);
  const auto known = grid.find(cell);
  ASSERT_TRUE(known);
  EXPECT_FLOAT_EQ(known->light.x, 2.5f);  // (6 * 1 + 18 * 3) / 24
  EXPECT_FLOAT_EQ(known->light.y, 1);
  EXPECT_FALSE(grid.find(at({5, 5, 5})));
}

TEST(BounceGrid, WantsNoMoreThanManySamples) {
  BounceGrid grid(100);
  const BounceCell cell = at({});
  add(grid, cell, 100);
  EXPECT_FALSE(grid.find(cell)->well);
  add(grid, cell, 2000);
  EXPECT_TRUE(grid.find(cell)->well);
}

TEST(BounceGrid, ForgetsAndIsBounded) {
  BounceGrid grid(2);
  for (float x = 0; x < 5; ++x) add(grid, at({x, 0, 0}), 50);
  EXPECT_EQ(grid.cells(), 2u);
  EXPECT_TRUE(grid.find(at({1, 0, 0})));
  EXPECT_FALSE(grid.find(at({2, 0, 0})));
  grid.forget();
  EXPECT_FALSE(grid.find(at({1, 0, 0})));
}

}  // namespace
}  // namespace saccade
