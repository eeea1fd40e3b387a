// Light in the grid beside walls that stand on a surface.
#include "cache/grid/cut_search.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cache/wall.h"

namespace saccade {
namespace {

using namespace test;

struct CutSearchTest : testing::Test, View {};

// Something stands on a surface: light of one side does not leak to the other, however large the cells.
TEST_F(CutSearchTest, LightDoesNotPassBelowAThinWall) {
  const auto error = [](const Obstacles* obstacles) {
    View view;
    Wall wall;
    wall.obstacles = obstacles;
    wall.noise = 0.5f;
    wall.light = [](float x) { return x < Curtain().x ? 1.f : 0.f; };
    for (int t = 0; t < 8; ++t) view.look(wall, 0.37f * t, t);
    return view.errors(wall, wall.light).first;
  };
  const Curtain curtain;
  EXPECT_LT(error(&curtain), 0.02);
  EXPECT_GT(error(nullptr), 0.05);  // without it, the border is a blurred one
}

// Two thin walls that meet, with a room on one side: that of small coordinates, or of large ones.
struct Corner final : Obstacles {
  explicit Corner(bool small) : sign(small ? -1.f : 1.f) {}
  bool isWithin(Vec3 p) const { return sign * (p.x - kX) > 0 && sign * (p.y - kY) > 0; }

  Hits find(const ProbeRays& rays) const override {
    Hits met;
    for (int i = 0; i < kRays; ++i) {
      const auto& [from, along, reach] = rays[i];
      const auto meet = [&, from = from, along = along, reach = reach](float distance, Vec3 normal,
                                                                       const auto& is_there) {
        const Vec3 at = from + along * distance;
        if (distance > 0 && distance <= std::min(reach, met[i].distance) && is_there(at))
          met[i] = {distance, normal};
      };
      if (along.x != 0)
        meet((kX - from.x) / along.x, {1, 0, 0}, [&](Vec3 at) { return sign * (at.y - kY) > 0; });
      if (along.y != 0)
        meet((kY - from.y) / along.y, {0, 1, 0}, [&](Vec3 at) { return sign * (at.x - kX) > 0; });
      if (along.z != 0) meet(-from.z / along.z, {0, 0, 1}, [](Vec3) { return true; });
    }
    return met;
  }

  static constexpr float kX = 23.6f * kPixel, kY = 19.6f * kPixel;
  float sign;
};

// Points of one side of the walls see them both, points of the other side one of them.
TEST_F(CutSearchTest, LightDoesNotPassBelowWallsThatMeet) {
  for (const bool small : {true, false}) {
    const Corner corner(small);
    View view;
    Wall wall;
    wall.obstacles = &corner;
    const auto light = [&](std::size_t i) {
      return corner.isWithin(wall.frame.surfaces->place(i).position) ? 1.f : 0.f;
    };
    for (int t = 0; t < 8; ++t) {
      wall.show(0.37f * static_cast<float>(t), t);
      for (std::size_t i = 0; i < kW * kH; ++i) wall.frame.surfaces->light(i).residual = light(i);
      view.add(wall);
    }
    double sum = 0;
    for (int y = 0; y < kH; ++y)
      for (int x = 0; x < kW; ++x)
        sum += std::pow(view.now.i.at(x, y) - light(wall.frame.surfaces->indexOf(x, y)), 2);
    EXPECT_LT(std::sqrt(sum / (kW * kH)), 1e-3);
  }
}

// Over the wall, parallel to it.
struct Sheet final : Obstacles {
  Hits find(const ProbeRays& rays) const override {
    Hits met;
    for (int i = 0; i < kRays; ++i)
      for (const float z : {0.f, kHeight})
        if (const float distance = (z - rays[i].from.z) / rays[i].along.z;
            rays[i].along.z != 0 && distance > 0 && distance <= std::min(rays[i].reach, met[i].distance))
          met[i] = {distance, {0, 0, 1}};
    return met;
  }
  static constexpr float kHeight = 12 * kPixel;
};

// A point of the sheet's other side comes into view, dark, where the lit wall below has been seen.
TEST_F(CutSearchTest, LightDoesNotReachTheOtherSideOfASheet) {
  const Sheet sheet;
  Wall wall;
  wall.obstacles = &sheet;
  for (int t = 0; t < 8; ++t) look(wall, 0.37f * static_cast<float>(t), t);
  wall.show(3, 8);
  SurfaceSamples& on = *wall.frame.surfaces;
  for (std::size_t i = 0; i < kW * kH; ++i)
    if (i != on.indexOf(kW / 2, kH / 2)) on[i] = {};
  on.place(on.indexOf(kW / 2, kH / 2)).position.z = Sheet::kHeight;
  on.light(on.indexOf(kW / 2, kH / 2)).residual = 0;
  add(wall);
  EXPECT_EQ(now.i.at(kW / 2, kH / 2), 0);
}

// The vertices of both sides of a cut are dropped and kept together.
TEST_F(CutSearchTest, WallsStayWhereVerticesAreDropped) {
  const Curtain curtain;
  Wall wall;
  wall.obstacles = &curtain;
  wall.light = [](float x) { return x < Curtain().x ? 1.f : 8 * (x - Curtain().x); };
  for (int t = 0; t < 40; ++t) {
    if (t == 30) grid.limit(1);
    look(wall, t < 4 ? 60.f : 0.3f + 10.f * static_cast<float>(t % 2), t);
  }
  EXPECT_GT(grid.dropped(), 0);
  EXPECT_LT(errors(wall, wall.light).first, 0.02);
}

}  // namespace
}  // namespace saccade
