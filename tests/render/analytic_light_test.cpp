#include "render/lights/analytic_light.h"

#include <gtest/gtest.h>

#include <numbers>

#include "render/test_scenes.h"

namespace saccade {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

float luminanceAt(const Scene& scene, Vec3 point, Vec3 normal) {
  return luminance(AnalyticLight(scene).at({point, normal, normal}, EmitterStrengths(scene)));
}

// A lamp of radiance 1 at height h that faces down, with a corner above the origin.
Scene lampAbove(float a, float b, float h) {
  Scene s;
  s.materials = {test::grey(0.5f)};
  s.meshes = {test::quad({0, 0, h}, {0, b, 0}, {a, 0, 0}, 0, {1, 1, 1})};
  return s;
}

// The form factor of a rectangle parallel to a surface, with a corner above the point (Howell, B-4).
float cornerFactor(float a, float b, float h) {
  const float x = a / h, y = b / h, p = std::sqrt(1 + x * x), q = std::sqrt(1 + y * y);
  return (x / p * std::atan(y / p) + y / q * std::atan(x / q)) / (2 * kPi);
}

TEST(AnalyticLight, OfARectangleOverheadIsItsFormFactor) {
  for (const float h : {0.1f, 1.f, 7.f})
    EXPECT_NEAR(luminanceAt(lampAbove(2, 3, h), {}, {0, 0, 1}), cornerFactor(2, 3, h), 1e-5);
}

// A lamp that reaches below the horizon counts down to it alone: half of a wall that goes on below.
TEST(AnalyticLight, EndsAtTheHorizon) {
  Scene s;
  s.materials = {test::grey(0.5f)};
  s.meshes = {test::quad({1, -1, -5}, {0, 0, 10}, {0, 2, 0}, 0, {1, 1, 1})};
  Scene above = s;
  above.meshes = {test::quad({1, -1, 0}, {0, 0, 5}, {0, 2, 0}, 0, {1, 1, 1})};
  EXPECT_GT(luminanceAt(s, {}, {0, 0, 1}), 0.05f);
  EXPECT_NEAR(luminanceAt(s, {}, {0, 0, 1}), luminanceAt(above, {}, {0, 0, 1}), 1e-5);
}

TEST(AnalyticLight, IsNothingBehindALampAndOnTheFarSideOfASurface) {
  const Scene s = lampAbove(2, 3, 1);
  EXPECT_EQ(luminanceAt(s, {0, 0, 2}, {0, 0, -1}), 0);
  EXPECT_EQ(luminanceAt(s, {}, {0, 0, -1}), 0);
  const Vec3 tilted = normalize(Vec3{0.3f, 0, 1});  // a shading normal that sees the lamp
  EXPECT_EQ(luminance(AnalyticLight(s).at({{}, tilted, {0, 0, -1}}, EmitterStrengths(s))), 0);
}

// Where rays hit a lamp, rounding puts some points before it, and some behind it.
TEST(AnalyticLight, IsNothingOnTheLampItself) {
  for (const float h : {0.7f, 1000.3f}) {
    const Scene s = lampAbove(2, 3, h);
    for (const float off : {std::nextafter(h, 0.f), h, std::nextafter(h, 2 * h)})
      for (const float up : {-1.f, 1.f})
        EXPECT_EQ(luminanceAt(s, {1, 1, off}, {0, 0, up}), 0) << h << " " << up;
  }
}

TEST(AnalyticLight, FollowsTheStrengthOfALamp) {
  Scene s = lampAbove(2, 3, 1);
  const float steady = luminanceAt(s, {}, {0, 0, 1});
  s.meshes[0].strength = Strength({{TimeNs(0), 0.25f}, {TimeNs(1), 0.25f}});
  EXPECT_NEAR(luminanceAt(s, {}, {0, 0, 1}), 0.25f * steady, 1e-6);
}

// A lamp of many triangles is left to its samples.
TEST(AnalyticLight, HoldsOnlyLampsOfFewSides) {
  Scene s = lampAbove(2, 3, 1);
  EXPECT_TRUE(AnalyticLight(s).holds(0u));
  for (int i = 0; i < 10; ++i)
    s.meshes[0].triangles.insert(s.meshes[0].triangles.end(), {{0, 1, 2}, {0, 2, 3}});
  EXPECT_FALSE(AnalyticLight(s).holds(0u));
  EXPECT_EQ(luminanceAt(s, {}, {0, 0, 1}), 0);
}

// In lanes as one by one: points that see all of a lamp, a part of it, and nothing.
TEST(AnalyticLight, IsTheSameForManyPoints) {
  Scene s = lampAbove(2, 3, 1);
  s.meshes.push_back(test::quad({1, -1, -5}, {0, 0, 10}, {0, 2, 0}, 0, {3, 2, 1}));
  const AnalyticLight light(s);
  int lit = 0;
  for (int block = 0; block < 4; ++block) {
    LaneVectors point, normal, geometric_normal, together;
    for (int i = 0; i < kLaneVectors; ++i) {
      const auto k = static_cast<float>(block * kLaneVectors + i);
      const Vec3 n = normalize(Vec3{std::cos(0.7f * k), std::sin(0.7f * k), 0.5f});
      point.set(i, {0.3f, std::sin(0.7f * k), 0.08f * k - 1.5f}), normal.set(i, n);
      geometric_normal.set(i, i % 3 == 0 ? n : normalize(n + Vec3{0.2f, 0, 0}));
    }
    const LitPoints points{point, normal, geometric_normal};
    light.at(points, {0x7fff}, EmitterStrengths(s), together);
    for (int i = 0; i < kLaneVectors - 1; ++i) {
      const float one = luminance(light.at(points.at(i), EmitterStrengths(s)));
      EXPECT_NEAR(luminance(together.at(i)), one, 1e-5f * (1 + one)) << block << " " << i;
      lit += one > 0.4f;
    }
  }
  EXPECT_GT(lit, 10);
}

}  // namespace
}  // namespace saccade
