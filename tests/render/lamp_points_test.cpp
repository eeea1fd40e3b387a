// Points on lamps, against the closed form of their light.
#include "render/lights/lamp_points.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/hash_rng.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

constexpr int kPoints = 1 << 14;

// Two lamps above a floor: one of radiance 1, and a smaller one that is 100 times as bright.
Scene twoLamps() {
  Scene s;
  s.materials = {test::grey(0.5f)};
  s.meshes = {test::quad({-1, -1, 2}, {0, 2, 0}, {1, 0, 0}, 0, {1, 1, 1}),
              test::quad({2, 0, 1}, {0, 0.3f, 0}, {0.3f, 0, 0}, 0, {100, 100, 100})};
  return s;
}

class LampPointsOf : public testing::Test {
 protected:
  Scene scene = twoLamps();
  AnalyticLight light{scene};
  EmitterStrengths strengths{scene};
  LitPoint floor{{0.2f, 0.1f, 0}, {0, 0, 1}, {0, 0, 1}};
  LampPoints lamps{light, strengths};

  LampPointsOf() { lamps.lookFrom(floor, {1, 1, 1}); }

  static float u(int i, std::uint32_t dimension) { return toUnit(mix32(mix32(dimension + 7) + i)); }
};

TEST_F(LampPointsOf, TheirGroupsAddUpToAllLight) {
  ASSERT_EQ(light.groups(), 2);
  EXPECT_NEAR(lamps.unoccluded(0) + lamps.unoccluded(1), luminance(light.at(floor, strengths)), 1e-5);
}

TEST_F(LampPointsOf, WeighOneInTheMean) {
  for (int group = 0; group < 2; ++group) {
    double sum = 0, squares = 0;
    for (int i = 0; i < kPoints; ++i) {
      const double w = lamps.at(group, u(i, 0), u(i, 1), u(i, 2)).weight;
      sum += w, squares += w * w;
    }
    const double mean = sum / kPoints, error = std::sqrt((squares / kPoints - mean * mean) / kPoints);
    EXPECT_NEAR(mean, 1, 4 * error) << group;
    EXPECT_LT(error, 0.01);
  }
}

TEST_F(LampPointsOf, LieOnTheirLamp) {
  for (int i = 0; i < 100; ++i) {
    const Vec3 large = lamps.at(0, u(i, 0), u(i, 1), u(i, 2)).position;
    EXPECT_NEAR(large.z, 2, 1e-6);
    EXPECT_LE(std::abs(large.x + 0.5f), 0.5f + 1e-5f);
    EXPECT_LE(std::abs(large.y), 1 + 1e-5f);
    EXPECT_NEAR(lamps.at(1, u(i, 0), u(i, 1), u(i, 2)).position.z, 1, 1e-6);
  }
}

// Numbers that are spaced evenly lie evenly along an edge.
TEST_F(LampPointsOf, AreEvenlySpacedOnARectangle) {
  constexpr int kRays = 8;
  for (int i = 0; i < kRays; ++i) {
    const float number = (static_cast<float>(i) + 0.5f) / kRays;
    const Vec3 first = lamps.at(0, 0, number, 0.3f).position, second = lamps.at(0, 0, 0.3f, number).position;
    EXPECT_NEAR(std::abs(first.y - -1), 2 * number, 1e-5) << i;
    EXPECT_NEAR(std::abs(second.x - -1), number, 1e-5) << i;
  }
}

// A steep surface sees a sliver of the large lamp alone. All of its points are there.
TEST_F(LampPointsOf, LieAboveTheHorizon) {
  const Vec3 normal = normalize(Vec3{1, 0, -0.07f});
  const LitPoint wall{{-0.2f, 0.1f, 0}, normal, normal};
  lamps.lookFrom(wall, {1, 1, 1});
  double sum = 0;
  for (int i = 0; i < kPoints; ++i) {
    const LampPoints::Point p = lamps.at(0, u(i, 0), u(i, 1), u(i, 2));
    ASSERT_GT(dot(p.position - wall.point, normal), -1e-6f);
    sum += p.weight;
  }
  EXPECT_NEAR(sum / kPoints, 1, 0.03);
}

TEST_F(LampPointsOf, ALampBehindTheSurfaceGivesNothing) {
  lamps.lookFrom({{0, 0, 3}, {0, 0, 1}, {0, 0, 1}}, {1, 1, 1});
  EXPECT_EQ(lamps.unoccluded(0), 0);
  EXPECT_EQ(lamps.unoccluded(1), 0);
}

}  // namespace
}  // namespace saccade
