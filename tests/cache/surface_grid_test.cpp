#include "cache/grid/surface_grid.h"

#include <gtest/gtest.h>

#include "cache/wall.h"

namespace saccade {
namespace {

using namespace test;

class SurfaceGridTest : public testing::Test, public View {};

TEST_F(SurfaceGridTest, ConstantLightIsFoundAtOnceAndExactly) {
  Wall wall;
  for (int t = 0; t < 3; ++t) {
    look(wall, 0.7f * t, t);
    EXPECT_LT(errors(wall, wall.light).first, 1e-5);
  }
}

// The mean of n samples of an even light is as good as all of them together, not as those of a cell.
TEST_F(SurfaceGridTest, NoiseOfEvenLightVanishes) {
  Wall wall;
  wall.noise = 1;
  for (int t = 0; t < 20; ++t) look(wall, 0.7f * t, t);
  EXPECT_LT(errors(wall, wall.light).first, 0.05);  // one sample: 0.58
}

TEST_F(SurfaceGridTest, DetailAppearsWhereSamplesProveIt) {
  Wall wall;
  wall.noise = 0.5f;
  wall.light = [](float x) { return 1 + 0.5f * std::sin(x / (8 * kPixel)); };  // a wave of 50 pixels
  look(wall, 0, 0);
  const double first = errors(wall, wall.light).first;
  for (int t = 1; t < 60; ++t) look(wall, 0.37f * t, t);
  EXPECT_LT(errors(wall, wall.light).first, 0.06);
  EXPECT_LT(errors(wall, wall.light).first, 0.4 * first);
}

TEST_F(SurfaceGridTest, ItsVarianceIsThatOfItsError) {
  Wall wall;
  wall.noise = 1;
  wall.light = [](float x) { return 1 + 0.5f * std::sin(x / (3 * kPixel)); };
  for (int t = 0; t < 60; ++t) look(wall, 0.37f * t, t);
  const auto [error, claimed] = errors(wall, wall.light);
  EXPECT_GT(claimed, 0.4 * error);
  EXPECT_LT(claimed, 1.5 * error);
}

// Where nothing casts a shadow the light of simple lamps has no noise at all, whatever its samples.
TEST_F(SurfaceGridTest, LightWithoutShadowsHasNoNoise) {
  Wall wall;
  wall.unoccluded = 2;
  wall.light = [](float) { return 0.f; };
  for (int t = 0; t < 5; ++t) look(wall, 0.7f * t, t);
  EXPECT_LT(errors(wall, [](float) { return 2.f; }).first, 1e-5);
  EXPECT_EQ(now.var_i.at(kW / 2, kH / 2), 0);
}

TEST_F(SurfaceGridTest, AShadowsEdgeComesOutSharp) {
  Wall wall;
  wall.unoccluded = 1;
  wall.light = [](float) { return 0.f; };
  wall.visibility = [](float x) { return x < 30 * kPixel ? 1.f : 0.f; };
  for (int t = 0; t < 60; ++t) look(wall, 0.37f * t - 11, t);
  EXPECT_NEAR(now.i.at(10, 20), 1, 0.01);
  EXPECT_NEAR(now.i.at(kW - 4, 20), 0, 0.01);
  EXPECT_LT(errors(wall, wall.visibility).first, 0.12);
}

// A wall thinner than any cell: light of one side does not leak to the other.
TEST_F(SurfaceGridTest, BothSidesOfAThinWallHaveLightOfTheirOwn) {
  Wall bright, dark;
  bright.light = [](float) { return 9.f; };
  dark.light = [](float) { return 0.f; };
  dark.normal = {0, 0, -1};
  for (int t = 0; t < 5; ++t) {
    look(bright, 0.7f * t, t);
    EXPECT_LT(errors(bright, bright.light).first, 1e-4);
    look(dark, 0.7f * t, t);
    EXPECT_LT(errors(dark, dark.light).first, 1e-5);
  }
}

TEST_F(SurfaceGridTest, ReadsTheSameAtTheSamePlace) {
  Wall wall;
  wall.noise = 1;
  for (int t = 0; t < 5; ++t) look(wall, 0.7f * t, t);
  GridEstimate again(kW, kH), once_more(kW, kH);
  grid.read({*wall.frame.surfaces, wall.frame.g, at}, pool, again);
  grid.read({*wall.frame.surfaces, wall.frame.g, at}, pool, once_more);
  for (int x = 0; x < kW; ++x) EXPECT_EQ(again.i.at(x, 7), once_more.i.at(x, 7));
}

// A change of light moves what is known, on all levels, and darkness has no light to lose.
TEST_F(SurfaceGridTest, LightMovesOnByAChange) {
  Wall wall;
  for (int t = 0; t < 3; ++t) look(wall, 0.7f * t, t);
  const FrameOnGrid frame{*wall.frame.surfaces, wall.frame.g, at};
  ImageF change(kW, kH);
  const auto lightAfter = [&](float d) {
    change.fill(d);
    grid.moveOn(frame, change, pool);
    grid.read(frame, pool, now);
    return now.i.at(kW / 2, kH / 2);
  };
  EXPECT_NEAR(lightAfter(0.25f), 1.25f, 1e-5);
  EXPECT_NEAR(lightAfter(-0.75f), 0.5f, 1e-5);
  EXPECT_NEAR(lightAfter(-2), 0, 1e-6);
}

// Where it has learned it finds what the last frame shows; elsewhere it knows nothing, and adds nothing.
TEST_F(SurfaceGridTest, KnowsPointsWithoutAFrame) {
  Wall wall;
  wall.noise = 1, wall.unoccluded = 1;
  wall.visibility = [](float x) { return x < 30 * kPixel ? 1.f : 0.2f; };
  for (int t = 0; t < 5; ++t) look(wall, 0.7f * t, t);
  GridEstimate frame(kW, kH);
  grid.read({*wall.frame.surfaces, wall.frame.g, at}, pool, frame);
  std::vector<PointSample> points;
  for (int i = 0; i < kW * kH; ++i)
    points.push_back({wall.frame.surfaces->place(static_cast<std::size_t>(i)), SurfaceKind::kDiffuse});
  points.push_back({{{500, 0, 0}, {0, 0, 1}, kPixel, 1}, SurfaceKind::kDiffuse});
  points.push_back({{{0.1f, 0.1f, 0}, {0, 0, 1}, 1e-9f, 1}, SurfaceKind::kDiffuse});
  std::vector<PlaceLight> light(points.size());
  light[0] = {.known = true, .residual = 77};
  const std::size_t vertices = grid.vertices();
  grid.readPoints(points, light);
  EXPECT_EQ(grid.vertices(), vertices);
  EXPECT_EQ(light[0].residual, 77) << "it was known";
  EXPECT_FALSE(light.end()[-2].known) << "it lies elsewhere";
  EXPECT_FALSE(light.end()[-1].known) << "it is seen from too near";
  ImageF relative(kW, kH), detail(kW, kH);
  grid.uncertainty({*wall.frame.surfaces, wall.frame.g, at}, pool, relative, &detail);
  for (int i = 1; i < kW * kH; ++i) {
    const int x = i % kW, y = i / kW;
    const PlaceLight& found = light[static_cast<std::size_t>(i)];
    ASSERT_TRUE(found.known) << x << " " << y;
    ASSERT_NEAR(found.residual + found.visibility, frame.i.at(x, y), 1e-6f) << x << " " << y;
    ASSERT_NEAR(found.shadow, detail.at(x, y), 1e-6f) << x << " " << y;
  }
}

TEST_F(SurfaceGridTest, IsTheSameForAnyNumberOfThreads) {
  Wall wall;
  wall.noise = 1, wall.unoccluded = 1;
  wall.visibility = [](float x) { return x < 30 * kPixel ? 1.f : 0.2f; };
  for (int t = 0; t < 5; ++t) look(wall, 0.7f * t, t);
  for (const int threads : {1, 5}) {
    View other(threads);
    for (int t = 0; t < 5; ++t) other.look(wall, 0.7f * t, t);
    for (int y = 0; y < kH; ++y) {
      for (int x = 0; x < kW; ++x) {
        ASSERT_EQ(now.i.at(x, y), other.now.i.at(x, y));
        ASSERT_EQ(now.var_i.at(x, y), other.now.var_i.at(x, y));
        ASSERT_EQ(now.var_step.at(x, y), other.now.var_step.at(x, y));
      }
    }
  }
}

TEST_F(SurfaceGridTest, ForgetsLightThatHasChanged) {
  Wall wall;
  for (int t = 0; t < 5; ++t) look(wall, 0.7f * t, t);
  wall.light = [](float) { return 5.f; };
  grid.forget();
  look(wall, 3.5f, 9);
  EXPECT_LT(errors(wall, wall.light).first, 1e-4);
}

// A long flight in a bounded grid: what was not used for longest goes, and what is in view stays true.
TEST_F(SurfaceGridTest, DropsWhatWasNotUsedForLongest) {
  const auto fly = [](View& view, int frames) {
    Wall wall;
    wall.light = [](float x) { return 1 + x; };
    for (int t = 0; t < frames; ++t) view.look(wall, 10.f * t, t);
    return wall;
  };
  View free;
  fly(free, 60);
  EXPECT_EQ(free.grid.dropped(), 0u);
  grid = SurfaceGrid({.max_vertices = free.grid.vertices() / 3});
  const Wall wall = fly(*this, 60);
  EXPECT_GT(grid.dropped(), 0u);
  EXPECT_LT(grid.vertices(), free.grid.vertices() / 2);
  EXPECT_LT(errors(wall, wall.light).first, 0.02);
}

// The frame before is read after vertices have gone.
TEST_F(SurfaceGridTest, DroppingLeavesTheFrameBeforeReadable) {
  Wall wall;
  grid = SurfaceGrid({.max_vertices = 1});
  for (int t = 0; t < 5; ++t) {
    look(wall, 3.f * t, t);
    if (t == 0) continue;
    GridEstimate before(kW, kH);
    grid.read({*wall.frame.surfaces, wall.frame.g, prev}, pool, before);
    for (int x = 0; x < kW; ++x) EXPECT_NEAR(before.i.at(x, 9), 1, 1e-5);
  }
}

TEST_F(SurfaceGridTest, PixelsWithoutASurfaceAreLeftOut) {
  Wall wall;
  wall.show(0, 1);
  for (int y = 0; y < kH; ++y)
    for (int x = 0; x < kW; ++x) wall.frame.surfaces->at(x, y).kind = SurfaceKind::kNone;
  grid.place(*wall.frame.surfaces, nullptr, pool, prev, at);
  grid.learn(grid.readAdded(grid.add({*wall.frame.surfaces, wall.frame.g, at}, pool), pool, now), pool);
  EXPECT_EQ(now.i.at(3, 3), 0);
  EXPECT_EQ(grid.vertices(), 0u);
}

TEST_F(SurfaceGridTest, PointsWhoseLightIsKnownAheadAddNothing) {
  Wall wall;
  wall.show(0, 1);
  for (int y = 0; y < kH; ++y)
    for (SurfacePoint& p : wall.frame.surfaces->row(y)) p.baked = true;
  wall.frame.surfaces->at(3, 3).baked = false;
  grid.place(*wall.frame.surfaces, nullptr, pool, prev, at);
  ASSERT_EQ(at.points.size(), 1u);
  EXPECT_EQ(at.points[0].index, 3u * kW + 3);
  EXPECT_EQ(grid.vertices(), 4u * kSlots);
}

}  // namespace
}  // namespace saccade
