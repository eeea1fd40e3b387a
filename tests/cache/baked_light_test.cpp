#include "cache/bake/baked_light.h"

#include <gtest/gtest.h>

#include "cache/wall.h"

namespace saccade {
namespace {

using namespace test;

// A wall with light, shadow and noise, seen from many places.
struct BakedLightTest : testing::Test, View {
  BakedLightTest() {
    wall.noise = 0.5f, wall.unoccluded = 1;
    wall.light = [](float x) { return 1 + 0.5f * std::sin(x / (8 * kPixel)); };
    wall.visibility = [](float x) { return x < 30 * kPixel ? 1.f : 0.f; };
    for (int t = 0; t < 60; ++t) look(wall, 0.37f * t, t);
  }
  static float truth(const Wall& wall, float x) { return wall.light(x) + wall.visibility(x); }

  struct Read {
    GridEstimate light{kW, kH};
    Image<std::uint32_t> known{kW, kH};
    int count() const {
      int sum = 0;
      for (int y = 0; y < kH; ++y)
        for (int x = 0; x < kW; ++x) sum += static_cast<int>(known.at(x, y));
      return sum;
    }
  };
  Read read(const BakedLight& baked) {
    Read read;
    baked.read({0, 0, kW, kH}, *wall.frame.surfaces, wall.frame.g, read.light);
    for (int y = 0; y < kH; ++y)
      for (int x = 0; x < kW; ++x) read.known.at(x, y) = wall.frame.surfaces->at(x, y).baked;
    return read;
  }
  // Root of the mean square error where the light is known, and of what `light` says of it.
  std::pair<double, double> errorsOf(const GridEstimate& light, const Read& where) const {
    double sum = 0, variance = 0;
    for (int y = 0; y < kH; ++y) {
      for (int x = 0; x < kW; ++x) {
        if (where.known.at(x, y) == 0) continue;
        sum += std::pow(light.i.at(x, y) - truth(wall, wall.xAt(x, y)), 2);
        variance += light.var_i.at(x, y);
      }
    }
    return {std::sqrt(sum / where.count()), std::sqrt(variance / where.count())};
  }

  Wall wall;
};

// An obstacle on the wall has light of its own on both sides. On each side the bake knows none of the other.
TEST_F(BakedLightTest, LightDoesNotPassBelowAThinWall) {
  const Curtain curtain;
  View view;
  wall.obstacles = &curtain;
  wall.unoccluded = 0, wall.visibility = [](float) { return 0.f; };
  wall.light = [](float x) { return x < Curtain().x ? 1.f : 0.f; };
  for (int t = 0; t < 60; ++t) view.look(wall, 0.37f * t, t);
  const Read from_bake = read(BakedLight(view.grid.levels(), {}, pool));
  EXPECT_GT(from_bake.count(), 0.8 * kW * kH);
  EXPECT_LT(errorsOf(from_bake.light, from_bake).first, 0.02);
}

TEST_F(BakedLightTest, IsAsTrueAsItsGrid) {
  const BakedLight baked(grid.levels(), {}, pool);
  const Read from_bake = read(baked);
  EXPECT_GT(from_bake.count(), 0.9 * kW * kH);
  const auto [error_of_grid, claimed_by_grid] = errorsOf(now, from_bake);
  const auto [error, claimed] = errorsOf(from_bake.light, from_bake);
  EXPECT_LT(error, 1.1 * error_of_grid);
  EXPECT_NEAR(claimed, claimed_by_grid, 0.3 * claimed_by_grid);
}

// Steps of a fraction of a pixel: the variance of the change grows with their square, as the grid's does. A
// bake judges detail at vertices, the grid at points, so that the two agree but roughly.
TEST_F(BakedLightTest, KnowsTheVarianceOfSteps) {
  const BakedLight baked(grid.levels(), {}, pool);
  for (const float px : {0.1f, 0.4f}) {
    wall.frame.g.motion_x.fill(px);
    GridEstimate from_grid(kW, kH);
    grid.read({*wall.frame.surfaces, wall.frame.g, at}, pool, from_grid);
    const Read from_bake = read(baked);
    double sum = 0, expected = 0;
    for (int y = 0; y < kH; ++y)
      for (int x = 0; x < kW; ++x)
        if (from_bake.known.at(x, y) != 0)
          sum += from_bake.light.var_step.at(x, y), expected += from_grid.var_step.at(x, y);
    EXPECT_GT(sum, 0.5 * expected) << px;
    EXPECT_LT(sum, 2 * expected) << px;
  }
  wall.frame.g.motion_x.fill(20);  // so far away, nothing is the same
  const GridEstimate light = read(baked).light;
  EXPECT_FLOAT_EQ(light.var_step.at(9, 9), 2 * light.var_i.at(9, 9));
}

TEST_F(BakedLightTest, LeavesOutWhatItDoesNotKnow) {
  const BakedLight baked(grid.levels(), {}, pool);
  wall.show(1000, 1);  // another part of the wall
  EXPECT_EQ(read(baked).count(), 0);
  wall.show(10, 1);
  EXPECT_EQ(read(baked).count(), kW * kH);
  wall.footprint_px = 1.f / 8;  // from nearby
  wall.show(10, 1);
  const Read near = read(baked);
  EXPECT_EQ(near.count(), 0);
  EXPECT_EQ(near.light.i.at(9, 9), 0);
  wall.footprint_px = 1;
  wall.show(10, 1);
  for (int y = 0; y < kH; ++y)
    for (SurfacePoint& p : wall.frame.surfaces->row(y)) p.kind = SurfaceKind::kNone;
  EXPECT_EQ(read(baked).count(), 0);
}

// From half the distance, only the coarser of the two levels knows something. After one look that is too
// little.
// Light is 1 to 2.5, and 1 of it has an edge at pixel 30 of the first view.
TEST_F(BakedLightTest, AsksForRaysAtTheEdgeOfAShadow) {
  wall.light = [](float) { return 1.f; };
  View view;
  for (int t = 0; t < 60; ++t) view.look(wall, 0.37f * t, t);
  const BakedLight baked(view.grid.levels(), {}, pool);
  wall.show(10, 1);
  read(baked);
  const SurfaceSamples& on = *wall.frame.surfaces;
  const auto share = [&](int from, int to, const auto& holds) {
    int count = 0;
    for (int y = 0; y < kH; ++y)
      for (int x = from; x < to; ++x) count += holds(on.indexOf(x, y));
    return static_cast<double>(count) / (kH * (to - from));
  };
  const auto near = [&](std::size_t i) { return on[i].near_shadow; };
  EXPECT_EQ(share(19, 22, near), 1);
  EXPECT_EQ(share(19, 22, [&](std::size_t i) { return on[i].near_shadow && on.shadows()[i].wanted > 0; }), 1);
  EXPECT_LT(share(0, 6, near), 0.02);
  EXPECT_LT(share(36, kW, near), 0.1);
}

// Points in any order, without a frame.
TEST_F(BakedLightTest, KnowsAtPointsWhatItKnowsInFrames) {
  const BakedLight baked(grid.levels(), {}, pool);
  wall.show(10, 1);
  const Read frame = read(baked);
  const SurfaceSamples& on = *wall.frame.surfaces;
  std::vector<PointSample> points;
  for (int i = 0; i < kW * kH; ++i)
    points.push_back({on.place(static_cast<std::size_t>(i) * 7 % (kW * kH)), SurfaceKind::kDiffuse});
  points.push_back({on.place(0), SurfaceKind::kNone});
  points.push_back({{{500, 0, 0}, {0, 0, 1}, kPixel, 1}, SurfaceKind::kDiffuse});
  std::vector<PlaceLight> light(points.size(), {.known = true});
  baked.read(points, light);
  EXPECT_FALSE(light.end()[-2].known) << "its kind is kNone";
  EXPECT_FALSE(light.end()[-1].known) << "it lies elsewhere";
  for (int i = 0; i < kW * kH; ++i) {
    const int at = i * 7 % (kW * kH), x = at % kW, y = at / kW;
    const auto k = static_cast<std::size_t>(i), index = static_cast<std::size_t>(at);
    ASSERT_EQ(light[k].known, frame.known.at(x, y) != 0) << x << " " << y;
    if (!light[k].known) continue;
    ASSERT_EQ(light[k].residual + light[k].visibility, frame.light.i.at(x, y)) << x << " " << y;
    ASSERT_EQ(light[k].shadow > 0, on[index].near_shadow) << x << " " << y;
  }
}

TEST_F(BakedLightTest, TakesVisibilityThatRaysTell) {
  const BakedLight baked(grid.levels(), {}, pool);
  wall.show(10, 1);
  const Read before = read(baked);
  SurfaceSamples& on = *wall.frame.surfaces;
  const std::vector<BakedLight::Pixel> pixels{{20, 9}, {21, 9}};
  std::vector<SurfaceShadow> shadows(on.shadows().size());
  shadows[on.indexOf(20, 9)] = {.wanted = 0.1f, .now = {0.25f, 1, 0}, .before = {0.75f, 1, 0.5f}};
  GridEstimate rays(kW, kH);
  baked.readAgain(pixels, on, wall.frame.g, {&shadows}, rays);
  EXPECT_EQ(rays.i.at(21, 9), before.light.i.at(21, 9)) << "no rays were wanted";
  EXPECT_EQ(rays.var_i.at(21, 9), before.light.var_i.at(21, 9));
  const float now = rays.i.at(20, 9), variance = rays.var_i.at(20, 9);
  EXPECT_LT(variance, before.light.var_i.at(20, 9)) << "what is left is that of all other light";
  baked.readAgain(pixels, on, wall.frame.g, {&shadows, &SurfaceShadow::before}, rays);
  EXPECT_NEAR(rays.i.at(20, 9) - now, 0.5f, 1e-6f);
  EXPECT_NEAR(rays.var_i.at(20, 9) - variance, 0.5f, 1e-6f);
  baked.readAgain(pixels, on, wall.frame.g, {}, rays);
  EXPECT_EQ(rays.i.at(20, 9), before.light.i.at(20, 9));
  EXPECT_EQ(rays.var_step.at(20, 9), before.light.var_step.at(20, 9));
}

TEST_F(BakedLightTest, LeavesOutVerticesWithFewSamples) {
  View other;
  other.look(wall, 0, 0);
  wall.footprint_px = 1.f / 2;
  wall.show(0, 0);
  EXPECT_GT(read(BakedLight(grid.levels(), {}, pool)).count(), 0.9 * kW * kH);
  EXPECT_EQ(read(BakedLight(other.grid.levels(), {}, pool)).count(), 0);
}

// Units of radiance are free: light is kept as exactly in a dim scene as in a bright one.
TEST_F(BakedLightTest, KnowsDimLightAsWellAsBright) {
  const auto lightOf = [this](float unit) {
    Wall lit;
    lit.noise = 0.5f * unit;
    lit.light = [unit](float x) { return unit * (1 + 0.5f * std::sin(x / (8 * kPixel))); };
    View other;
    for (int t = 40; t < 60; ++t) other.look(lit, 0.37f * t, t);
    return read(BakedLight(other.grid.levels(), {}, pool)).light;
  };
  wall.unoccluded = 0;
  wall.show(20, 1);
  const GridEstimate usual = lightOf(1);
  EXPECT_GT(usual.i.at(9, 9), 0.4f);
  for (const float unit : {0x1p-20f, 0x1p20f}) {
    const GridEstimate other = lightOf(unit);
    for (int x = 0; x < kW; ++x) {
      ASSERT_EQ(other.i.at(x, 9), unit * usual.i.at(x, 9)) << unit << " " << x;
      ASSERT_EQ(other.var_i.at(x, 9), unit * unit * usual.var_i.at(x, 9)) << unit << " " << x;
    }
  }
}

TEST_F(BakedLightTest, IsTheSameForAnyNumberOfThreads) {
  const BakedLight baked(grid.levels(), {}, pool);
  const Read expected = read(baked);
  TilePool one(1);
  const BakedLight other(grid.levels(), {}, one);
  EXPECT_EQ(other.vertices(), baked.vertices());
  const Read found = read(other);
  for (int y = 0; y < kH; ++y)
    for (int x = 0; x < kW; ++x) ASSERT_EQ(found.light.i.at(x, y), expected.light.i.at(x, y));
}

}  // namespace
}  // namespace saccade
