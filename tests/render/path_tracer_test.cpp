// Light against closed forms.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "render/render_mean.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

using test::Mean;
using test::renderMean;

// Every surface emits 1 and reflects a: after B indirect bounces the radiance is 1 + a + ... + a^(B+1).
TEST(Furnace, EqualsTheGeometricSeries) {
  for (int bounces : {0, 1, 3}) {
    const double a = 0.5, expected = (1 - std::pow(a, bounces + 2)) / (1 - a);
    const Mean m = renderMean(test::furnace(0.5f, 1), bounces, 64);
    EXPECT_NEAR(m.mean / expected, 1, 1e-3) << bounces << " bounces, standard error " << m.error;
  }
}

TEST(Furnace, IsTheSameInOneChannelAndThree) {
  EXPECT_NEAR(renderMean(test::furnace(0.5f, 1), 2, 4, 16, 1).mean,
              renderMean(test::furnace(0.5f, 1), 2, 4, 16, 3).mean, 1e-5);
}

// Irradiance at height h under the middle of a square of half-width a, from four corner form factors. E = L *
// 4 * (a / sqrt(a^2 + h^2)) * atan(a / sqrt(a^2 + h^2)).
TEST(AreaLight, SquareOverAFloor) {
  Scene scene = test::floorFromAbove(0.6f);
  const double a = 0.7, h = 1.5, L = 3;
  scene.meshes.push_back(
      test::quad({-0.7f, -0.7f, 1.5f}, {0, 1.4f, 0}, {1.4f, 0, 0}, 0, {3, 3, 3}));  // facing down
  scene.T_world_camera.position.z = 1;                                              // below the light
  const double s = std::sqrt(a * a + h * h), irradiance = L * 4 * (a / s) * std::atan(a / s);
  const Mean m = renderMean(std::move(scene), 0, 256);
  EXPECT_NEAR(m.mean, 0.6 / std::numbers::pi * irradiance, 5 * m.error);
  EXPECT_LT(m.error / m.mean, 4e-3);
}

// A sphere of radius r at distance d straight above lights a floor with E = pi L (r/d)^2.
TEST(AreaLight, SphereOverAFloor) {
  Scene scene = test::floorFromAbove(0.6f);
  scene.spheres.push_back({"light", {0, 0, 2}, 0.5f, 0, {3, 3, 3}});
  scene.T_world_camera.position.z = 1;
  const Mean m = renderMean(std::move(scene), 0, 256);
  constexpr double kTruth = 0.6 * 3 * 0.25 * 0.25, kOffset = 5e-4;  // rays start a little above the floor
  EXPECT_NEAR(m.mean, kTruth, 5 * m.error + kOffset * kTruth);
  EXPECT_LT(m.error / m.mean, 4e-3);
}

TEST(Materials, OneSidedIsBlackFromBehind) {
  Scene scene = test::furnace(0.5f, 0);
  scene.meshes.push_back(test::quad({-0.3f, 0.9f, -0.3f}, {0.6f, 0, 0}, {0, 0, 0.6f}, 0, {9, 9, 9}));
  EXPECT_GT(renderMean(scene, 1, 4).mean, 0.01);
  for (Mesh& mesh : scene.meshes)
    std::swap(mesh.triangles[0][1], mesh.triangles[0][2]),
        std::swap(mesh.triangles[1][1], mesh.triangles[1][2]);
  std::swap(scene.meshes.back().triangles[0][1], scene.meshes.back().triangles[0][2]);
  std::swap(scene.meshes.back().triangles[1][1], scene.meshes.back().triangles[1][2]);
  EXPECT_GT(renderMean(scene, 1, 4).mean, 0.01);  // two-sided: winding does not matter
  scene.materials[0].twosided = false;
  EXPECT_EQ(renderMean(scene, 1, 4).mean, 0);
}

// Its power overflows, and with it every weight: such paths are dark, and no NaN leaves the renderer.
TEST(AreaLight, BeyondFloatsStaysFinite) {
  Scene scene = test::floorFromAbove(0.6f);
  scene.meshes.push_back(test::quad({-1, -1, 1.5f}, {0, 2, 0}, {2, 0, 0}, 0, {3e38f, 3e38f, 3e38f}));
  scene.T_world_camera.position.z = 1;
  EXPECT_TRUE(std::isfinite(renderMean(std::move(scene), 2, 4).mean));
}

}  // namespace
}  // namespace saccade
