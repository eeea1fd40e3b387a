// Lights that are no surface, against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "render/render_mean.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

constexpr double kPi = std::numbers::pi;

// At the middle of a floor under a point light of intensity I at height h: a / pi * I / h^2.
TEST(PointLight, LightsByTheSquareOfTheDistance) {
  Scene scene = test::floorFromAbove(0.6f);
  scene.point_lights = {{{0, 0, 5}, {7, 7, 7}}};
  const test::Mean m = test::renderMean(std::move(scene), 0, 4);
  EXPECT_NEAR(m.mean, 0.6 / kPi * 7 / 25, 1e-3 * m.mean);
}

// a / pi * E cos.
TEST(DirectionalLight, LightsByTheCosine) {
  Scene scene = test::floorFromAbove(0.6f);
  scene.directional_lights = {{{0, 0.6f, -0.8f}, {7, 7, 7}}};
  const test::Mean m = test::renderMean(std::move(scene), 0, 4);
  EXPECT_NEAR(m.mean, 0.6 / kPi * 7 * 0.8, 1e-3 * m.mean);
}

// All at once: the lamp has samples of its own. Distant light is chosen by its irradiance, and weighed by how
// rarely.
TEST(DistantLights, AddUp) {
  Scene scene = test::floorFromAbove(0.6f);
  scene.point_lights = {{{0, 0, 5}, {7, 7, 7}}};
  scene.directional_lights = {{{0, 0, -1}, {0.3f, 0.3f, 0.3f}}};
  scene.environment = {{0.05f, 0.05f, 0.05f}, {}, {}};
  const test::Mean m = test::renderMean(std::move(scene), 0, 256);
  EXPECT_NEAR(m.mean, 0.6 / kPi * (7. / 25 + 0.3 + 0.05 * kPi), 4 * m.error);
  EXPECT_LT(m.error / m.mean, 0.01);
}

// A sky outside a closed room costs it nothing: no noise, and no light. Nor does the size of what stands
// there.
TEST(DistantLights, LeaveAClosedRoomAlone) {
  Scene room = test::furnace(0.6f, 0);
  room.point_lights = {{{0, 0.5f, 0}, {1, 1, 1}}};
  const test::Mean alone = test::renderMean(room, 0, 16);
  room.environment = {{5, 5, 5}, {}, {}};
  room.directional_lights = {{{0, 0, -1}, {5, 5, 5}}};
  room.meshes.push_back(test::quad({-10, -10, -3}, {20, 0, 0}, {0, 20, 0}, 0));
  const test::Mean under_a_sky = test::renderMean(std::move(room), 0, 16);
  EXPECT_NEAR(under_a_sky.mean, alone.mean, 1e-3 * alone.mean);
  EXPECT_NEAR(under_a_sky.error, alone.error, 2e-2 * alone.error);
}

// A floor under a sky of radiance L: a L, by the light's samples and by chance together.
TEST(Environment, OfOneRadianceLightsByTheAlbedo) {
  Scene scene = test::floorFromAbove(0.6f);
  scene.environment = {{2, 2, 2}, {}, {}};
  const test::Mean m = test::renderMean(std::move(scene), 0, 64);
  EXPECT_NEAR(m.mean, 1.2, 4 * m.error);
  EXPECT_LT(m.error / m.mean, 0.01);
}

TEST(Environment, IsSeenWhereNothingIsHit) {
  Scene scene = test::floorFromAbove(0.6f);
  scene.environment = {{2, 2, 2}, {}, {}};
  scene.T_world_camera = {};  // away from the floor
  const test::Mean m = test::renderMean(std::move(scene), 0, 2);
  EXPECT_EQ(m.mean, 2);
  EXPECT_EQ(m.error, 0);
}

// A point light behind a pane is dimmed by what the pane reflects: 2 f / (1 + f), f = ((n - 1) / (n + 1))^2.
TEST(PointLight, ShinesThroughAPaneAndAMask) {
  Scene scene = test::floorFromAbove(0.6f);
  scene.point_lights = {{{0, 0, 5}, {7, 7, 7}}};
  Material pane = test::grey(0), mask = test::grey(0);
  pane.model.kind = BsdfKind::kThinDielectric;
  mask.opacity.color0 = {0.25f, 0.25f, 0.25f};
  scene.materials.push_back(pane), scene.materials.push_back(mask);
  scene.meshes.push_back(test::quad({-1, -1, 4}, {2, 0, 0}, {0, 2, 0}, 1));
  scene.meshes.push_back(test::quad({-1, -1, 4.5f}, {2, 0, 0}, {0, 2, 0}, 2));
  const test::Mean m = test::renderMean(std::move(scene), 0, 4);
  const double f = 0.04;
  EXPECT_NEAR(m.mean, 0.6 / kPi * 7 / 25 * 0.75 * (1 - 2 * f / (1 + f)), 1e-3 * m.mean);
}

// Through a pane and a mask, the sky is found by shadow rays and by chance: their weights add up to 1.
TEST(Environment, ShinesThroughAPaneAndAMask) {
  Scene scene = test::floorFromAbove(0.6f);
  scene.environment = {{2, 2, 2}, {}, {}};
  Material both = test::grey(0);
  both.model.kind = BsdfKind::kThinDielectric;
  both.opacity.color0 = {0.5f, 0.5f, 0.5f};
  both.specular = constantColor({0, 0, 0});
  scene.materials.push_back(both);
  scene.meshes.push_back(test::quad({-5e3f, -5e3f, 4}, {1e4f, 0, 0}, {0, 1e4f, 0}, 1));
  // Diffuse light through the pane: 1/2 + 1/2 the mean over directions of what it lets through.
  const auto through = [](double c) {
    const double t = std::sqrt(1 - (1 - c * c) / 2.25), s = (c - 1.5 * t) / (c + 1.5 * t),
                 p = (1.5 * c - t) / (1.5 * c + t), f = (s * s + p * p) / 2;
    return 1 - 2 * f / (1 + f);
  };
  double mean = 0;
  for (int i = 0; i < 1000; ++i) mean += through((i + 0.5) / 1000) * 2 * (i + 0.5) / 1000 / 1000;
  const test::Mean m = test::renderMean(std::move(scene), 0, 256);
  EXPECT_NEAR(m.mean, 1.2 * (0.5 + 0.5 * mean), 4 * m.error);
  EXPECT_LT(m.error / m.mean, 0.005);
}

}  // namespace
}  // namespace saccade
