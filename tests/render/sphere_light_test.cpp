// The light of spheres in closed form, against formulas and sums over directions.
#include "render/lights/sphere_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/hash_rng.h"
#include "render/lanes_of_light.h"
#include "render/lights/lamp_points.h"
#include "render/lights/sphere_cone.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

constexpr double kPi = std::numbers::pi;

float u(std::uint32_t i, std::uint32_t dimension) {
  return toUnit(mix32(mix32(dimension + 7) + i));
}

Vec3 tilted(float angle) {
  return {std::sin(angle), 0, std::cos(angle)};
}

// A mean over directions that are spread evenly in the cone.
double sumOver(Vec3 center, float radius, const LitPoint& p) {
  constexpr std::uint32_t kDirections = 1 << 17;
  const SphereCone cone(p.point, center, radius);
  double sum = 0;
  for (std::uint32_t i = 0; i < kDirections; ++i) {
    const Vec3 w = cone.at((static_cast<float>(i) + 0.5f) / kDirections, toUnit(i * 0x9e3779b9u)).w;
    if (dot(w, p.geometric_normal) > 0) sum += std::max(0.f, dot(w, p.normal));
  }
  return sum / kDirections * cone.solidAngle() / kPi;
}

TEST(SphereLight, AboveTheHorizonIsTheSquareOfTheSineTimesTheCosine) {
  const Vec3 n = tilted(0.5f);
  EXPECT_NEAR(sphereFormFactor({0, 0, 4}, 1, {{}, n, n}), std::cos(0.5) / 16, 1e-6);
  EXPECT_NEAR(sphereFormFactor({0, 0, 1.0001f}, 1, {{}, {0, 0, 1}, {0, 0, 1}}), 1, 1e-3);
}

// Half of a sphere whose centre lies on the horizon, as far away as 1 / sin(s) [Snyder 1996]: (s - sin s cos
// s) / pi.
TEST(SphereLight, OnTheHorizonIsThatOfTheUpperHalf) {
  for (const double s : {0.01, 0.3, 1.2}) {
    const auto distance = static_cast<float>(1 / std::sin(s));
    const float factor = sphereFormFactor({distance, 0, 0}, 1, {{}, {0, 0, 1}, {0, 0, 1}});
    EXPECT_NEAR(factor, (s - std::sin(s) * std::cos(s)) / kPi, 1e-4 * s * s) << s;
  }
}

TEST(SphereLight, IsTheSumOverItsDirections) {
  int cut = 0;
  for (std::uint32_t i = 0; i < 60; ++i) {
    const float turn = 6.28f * u(i, 2), radius = 0.05f + 0.9f * u(i, 3), geometric = 0.6f * (u(i, 4) - 0.5f);
    const LitPoint p{{}, tilted(3.2f * u(i, 5)), tilted(3.2f * u(i, 5) + geometric)};
    const Vec3 center = normalize(Vec3{std::cos(turn), std::sin(turn), u(i, 6) - 0.5f});
    const double sum = sumOver(center, radius, p);
    EXPECT_NEAR(sphereFormFactor(center, radius, p), sum, 2e-4 * radius * radius) << i;
    cut += sum > 0 && std::min(dot(center, p.normal), dot(center, p.geometric_normal)) < radius;
  }
  EXPECT_GT(cut, 20);
}

TEST(SphereLight, IsNothingBelowTheHorizonInsideAndOnItself) {
  EXPECT_EQ(sphereFormFactor({0, 0, -2}, 1, {{}, {0, 0, 1}, {0, 0, 1}}), 0);
  EXPECT_EQ(sphereFormFactor({0, 0, 0.5f}, 1, {{}, {0, 0, 1}, {0, 0, 1}}), 0);
  EXPECT_NEAR(sphereFormFactor({0, 0, -1}, 1, {{}, {0, 0, 1}, {0, 0, 1}}), 0, 1e-6);
}

// A floor below a small ball and a large one, which the floor cuts.
class SphereLamps : public testing::Test {
 protected:
  SphereLamps() {
    scene.materials = {test::grey(0.5f)};
    scene.meshes = {test::quad({-1, -1, 2}, {0, 2, 0}, {1, 0, 0}, 0, {1, 1, 1})};
    scene.spheres = {{"small", {0.5f, 0, 1}, 0.1f, 0, {100, 100, 100}},
                     {"large", {3, 0, 0}, 1, 0, {1, 1, 1}}};
  }
  Scene scene;
  const LitPoint floor{{0.2f, 0.1f, 0}, {0, 0, 1}, {0, 0, 1}};
};

// As far away as the eye can tell, a sphere is a point.
TEST_F(SphereLamps, AddTheirLightToThatOfFlatOnes) {
  const AnalyticLight light(scene);
  const EmitterStrengths strengths(scene);
  EXPECT_TRUE(light.holds(1u) && light.holds(2u));
  scene.meshes.clear();
  scene.spheres.pop_back();
  const Vec3 to{0.3f, -0.1f, 1};
  const double point = 100 * 0.01 / dot(to, to) * normalize(to).z;  // intensity / pi, distance, cosine
  EXPECT_NEAR(luminance(AnalyticLight(scene).at(floor, EmitterStrengths(scene))), point, 1e-4 * point);
}

TEST_F(SphereLamps, AreTheSameForManyPoints) {
  test::expectTheSameInLanes(
      scene, [](float) { return 2.f; }, 0.1f, 7);
}

TEST_F(SphereLamps, PointsOnThemWeighOneInTheMean) {
  const AnalyticLight light(scene);
  const EmitterStrengths strengths(scene);
  LampPoints lamps(light, strengths);
  lamps.lookFrom(floor, {1, 1, 1});
  constexpr std::uint32_t kPoints = 1 << 14;
  for (int group = 0; group < 3; ++group) {
    double sum = 0;
    for (std::uint32_t i = 0; i < kPoints; ++i) {
      const LampPoints::Point at = lamps.at(group, u(i, 0), u(i, 1), u(i, 2));
      sum += at.weight;
      if (group == 0) continue;
      const Sphere& ball = scene.spheres[static_cast<std::size_t>(group - 1)];
      EXPECT_NEAR(length(at.position - ball.center), ball.radius, 2e-3f * ball.radius);
    }
    EXPECT_NEAR(sum / kPoints, 1, 0.02) << group;
  }
}

}  // namespace
}  // namespace saccade
