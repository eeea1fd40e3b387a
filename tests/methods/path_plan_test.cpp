#include "methods/path_plan.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/tile_pool.h"

namespace saccade {
namespace {

constexpr int kW = 32, kH = 24;
constexpr PathPlan kPlan{.asked = 8, .usual = 6, .target = 0.1f, .most = 8};
constexpr PathPlan kMoving{.asked = 8, .usual = 6, .target = 0.1f, .most = 8, .target_of_change = 0.02f};

struct PathPlanTest : testing::Test {
  PathPlanTest() {
    for (int y = 0; y < kH; ++y)
      for (SurfacePoint& p : on.row(y)) p.share = 1, p.kind = SurfaceKind::kDiffuse;
  }
  void plan(std::uint32_t frame = 0) { planPaths(kPlan, {error}, frame, pool, had_others, on); }
  double mean() const {
    double sum = 0;
    for (int y = 0; y < kH; ++y)
      for (const SurfacePoint& p : on.row(y)) sum += p.paths;
    return sum / (kW * kH);
  }

  TilePool pool{2};
  SurfaceSamples on{kW, kH, 1};
  ImageF error{kW, kH};
  std::vector<char> had_others;
};

TEST_F(PathPlanTest, TheBetterLightIsKnownTheFewerPaths) {
  const std::pair<float, double> expected[]{{0, 0}, {0.01f, 0.6}, {0.05f, 3}, {0.1f, 6}, {0.11f, 7.26}};
  for (const auto& [relative, paths] : expected) {
    error.fill(relative);
    plan();
    EXPECT_NEAR(mean(), paths, 0.02 * paths) << relative;
  }
}

TEST_F(PathPlanTest, WhatIsKnownBadlyGetsManyPaths) {
  error.fill(0.05f);  // 3 paths
  constexpr float kOfRow[] = {0.1f, 0.2f, 0.3f, 1e30f};
  constexpr std::uint32_t kExpected[] = {6, 24, 54, 64};
  for (int y = 0; y < 4; ++y) error.at(7, y) = kOfRow[y];
  plan();
  for (int y = 0; y < 4; ++y) EXPECT_EQ(on.at(7, y).paths, kExpected[y]) << y;
  EXPECT_EQ(on.at(8, 0).paths, 3u);
}

// Their error does not fall, so that others would go without.
TEST_F(PathPlanTest, PlasticsGetNoMoreThanAsked) {
  error.fill(0.05f);
  error.at(7, 0) = 0.11f, error.at(7, 1) = 1;
  for (int y = 0; y < 2; ++y) on.at(7, y).kind = SurfaceKind::kMixed;
  plan();
  EXPECT_EQ(on.at(7, 0).paths, 7u);
  EXPECT_EQ(on.at(7, 1).paths, 8u);
}

// A change that is known badly takes more paths than light does.
TEST_F(PathPlanTest, TheWorseAChangeIsKnownTheMorePaths) {
  error.fill(0.05f);  // 3 paths
  ImageF change(kW, kH);
  constexpr float kOfRow[] = {0, 0.5f, 1, 2, 9};  // over the error aimed at
  for (int y = 0; y < 5; ++y) change.at(7, y) = kOfRow[y] * kMoving.target_of_change;
  planPaths(kMoving, {error, &change}, 0, pool, had_others, on);
  constexpr std::uint32_t kExpected[] = {3, 3, 6, 48, 64};
  for (int y = 0; y < 5; ++y) EXPECT_EQ(on.at(7, y).paths, kExpected[y]) << y;
}

TEST_F(PathPlanTest, AllPathsTogetherAreNoMoreThanAsked) {
  error.fill(1e18f);
  ImageF change(kW, kH);
  change.fill(1);
  planPaths(kMoving, {error, &change}, 0, pool, had_others, on);
  EXPECT_NEAR(mean(), kMoving.asked, 0.05 * kMoving.asked);
}

// Fractions of a path are rounded up in one frame and down in another.
TEST_F(PathPlanTest, FractionsAreSpreadOverFrames) {
  error.fill(0.005f);  // 0.3 paths
  int sum = 0;
  for (std::uint32_t frame = 0; frame < 100; ++frame) {
    plan(frame);
    sum += static_cast<int>(on.at(7, 7).paths);
  }
  EXPECT_NEAR(sum, 30, 2);
}

TEST_F(PathPlanTest, WhatIsLeftGoesToSurfacesThatShareNoLight) {
  const int others = kW * kH / 4;
  for (int i = 0; i < others; ++i) on[static_cast<std::size_t>(i)].kind = SurfaceKind::kNone;
  error.fill(0.05f);
  plan();  // 3 paths for three quarters of the pixels, of 6 for each; a path and its partner are two
  EXPECT_EQ(on[0].paths, 7u);
  EXPECT_LE(mean(), kPlan.usual);

  error.fill(1);  // nothing is left
  plan();
  EXPECT_EQ(on[0].paths, 4u);

  error.fill(0);
  for (std::size_t i = 1; i < static_cast<std::size_t>(others); ++i) on[i].kind = SurfaceKind::kDiffuse;
  plan();
  EXPECT_EQ(on[0].paths, 32u);
}

// Such a pixel has no pairs and no history.
TEST_F(PathPlanTest, PixelsThatNewlyShowSuchASurfaceGetMore) {
  error.fill(1);  // nothing is left
  on[7].kind = SurfaceKind::kNone;
  plan();
  EXPECT_EQ(on[7].paths, 4u);  // in the first frame nothing is known of the one before
  on[9].kind = SurfaceKind::kNone;
  plan();
  EXPECT_EQ(on[7].paths, 4u);
  EXPECT_EQ(on[9].paths, 32u);
  plan();
  EXPECT_EQ(on[9].paths, 4u);
}

// All of them together get a tenth of the paths asked, besides.
TEST_F(PathPlanTest, ManyNewOnesShareABound) {
  error.fill(1);
  plan();
  const int others = kW * kH / 2;
  for (int i = 0; i < others; ++i) on[static_cast<std::size_t>(i)].kind = SurfaceKind::kNone;
  plan();
  EXPECT_EQ(on[0].paths, 5u);  // 0.1 * 8 * 2 more than 4, rounded down
}

TEST_F(PathPlanTest, PointsBesideSuchASurfaceAreSampled) {
  SurfaceSamples two(kW, kH, 2);
  ImageF known(two.columns(), kH);
  for (SurfacePoint& p : two.of(3, 4)) p.share = 0.5f, p.kind = SurfaceKind::kDiffuse;
  planPaths(kPlan, {known}, 0, pool, had_others, two);
  EXPECT_EQ(two.of(3, 4)[0].paths, 0u);
  two.of(3, 4)[1].kind = SurfaceKind::kNone;
  planPaths(kPlan, {known}, 0, pool, had_others, two);
  EXPECT_EQ(two.of(3, 4)[0].paths, 1u);
}

}  // namespace
}  // namespace saccade
