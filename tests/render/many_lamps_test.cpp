// Pictures lit by several lamps, against closed forms and against each other.
#include <gtest/gtest.h>

#include <numbers>

#include "render/lights/analytic_light.h"
#include "render/lights/delta_lamps.h"
#include "render/render_mean.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

// A floor under lamps of several kinds, sizes and directions. All have a closed form.
Scene floorUnderManyLamps() {
  Scene s = test::floorFromAbove(0.6f);
  for (int i = 0; i < 6; ++i) {
    const float x = static_cast<float>(i) - 2.5f, size = 0.2f + 0.1f * static_cast<float>(i);
    s.meshes.push_back(test::quad({x, 1, 1}, {0, size, 0.1f * x}, {size, 0, 0}, 0, Rgb{1, 1, 1} * (7.f - x)));
    s.point_lights.push_back({{x, -2, 2}, Rgb{1, 1, 1} * (4.f + x)});
  }
  s.spot_lights = {{{0.5f, 0, 3}, normalize(Vec3{-0.1f, 0, -1}), {9, 9, 9}, 0.2f, 0.4f}};
  return s;
}

// Radiance of a white floor at the origin, by closed forms.
Rgb whiteAtOrigin(const Scene& scene) {
  Rgb sum = AnalyticLight(scene).at({{}, {0, 0, 1}, {0, 0, 1}}, EmitterStrengths(scene));
  const DeltaLamps deltas(scene, Lamps(scene));
  for (std::size_t i = 0; i < deltas.size(); ++i) {
    const IncidentLight light = deltas.at(i, {});
    sum = sum + light.radiance * (std::max(0.f, light.direction.z) / kPi);
  }
  return sum;
}

// Samples of lamps and of the surface together have the right mean, at a diffuse floor.
TEST(ManyLamps, AddUpToTheClosedForm) {
  const Scene scene = floorUnderManyLamps();
  const Rgb white = whiteAtOrigin(scene);
  const test::Mean m = test::renderMean(scene, 0, 256);
  EXPECT_NEAR(m.mean, 0.6f * luminance(white), 4 * m.error + 1e-4 * m.mean);
  EXPECT_LT(m.error / m.mean, 0.003);
}

// Behind a pane that paths and shadow rays go straight through.
TEST(ManyLamps, AddUpBehindAMask) {
  Scene scene = floorUnderManyLamps();
  const Rgb white = whiteAtOrigin(scene);
  Material mask = test::grey(0);
  mask.opacity.color0 = {0.25f, 0.25f, 0.25f};
  scene.materials.push_back(mask);
  scene.meshes.push_back(test::quad({-9, -9, 0.5f}, {18, 0, 0}, {0, 18, 0}, 1));
  scene.T_world_camera.position.z = 0.4;
  const test::Mean m = test::renderMean(scene, 0, 256);
  EXPECT_NEAR(m.mean, 0.75f * 0.6f * luminance(white), 4 * m.error + 1e-3 * m.mean);
}

// Two closed rooms, side by side; the camera stands in one. Each has a lamp at its ceiling.
Scene twoRooms(float light_here, float light_there) {
  Scene s = test::furnace(0.6f, 0);
  const auto add = [&](float x, float light) {
    s.meshes.push_back(
        test::quad({x - 0.2f, 0.9f, -0.2f}, {0.4f, 0, 0}, {0, 0, 0.4f}, 0, Rgb{1, 1, 1} * light));
  };
  Scene there = test::furnace(0.6f, 0);
  for (Mesh& wall : there.meshes) {
    for (Vec3& p : wall.positions) p.x += 2.2f;
    s.meshes.push_back(wall);
  }
  add(0, light_here);
  if (light_there > 0) add(2.2f, light_there);
  return s;
}

// A lamp that no surface here sees costs little noise, however strong it is.
TEST(ManyLamps, AStrongLampInAnotherRoomDoesNotStarveTheOneHere) {
  const auto noise = [](const Scene& scene) {
    const ImageF a = test::renderFrame(scene, SeedPlan::independent(1, 0, 16), {1, 1}, 32).samples.I2;
    const ImageF b = test::renderFrame(scene, SeedPlan::independent(2, 0, 16), {1, 1}, 32).samples.I2;
    double square = 0;
    for (int y = 0; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x) square += std::pow(a.at(x, y) - b.at(x, y), 2);
    return std::sqrt(square);
  };
  const double alone = noise(twoRooms(5, 0)), beside = noise(twoRooms(5, 5000));
  EXPECT_LT(beside, 1.4 * alone);
}

// A spot gives I a / pi / d^2 within its beam. From there to the cutoff it falls linearly, and is nothing
// beyond.
TEST(SpotLight, FallsOffLinearlyWithTheAngle) {
  const float from = 0.3f, to = 0.5f;
  for (const float angle : {0.f, 0.29f, 0.35f, 0.45f, 0.51f, 3.f}) {
    Scene scene = test::floorFromAbove(0.6f);
    scene.spot_lights = {{{0, 0, 4}, {std::sin(angle), 0, -std::cos(angle)}, {8, 8, 8}, from, to}};
    const float share = angle < from ? 1 : angle > to ? 0 : (to - angle) / (to - from);
    const double expected = 0.6f / kPi * 8 / 16 * share;
    const test::Mean m = test::renderMean(scene, 0, 4);
    EXPECT_NEAR(m.mean, expected, 0.01 * expected) << angle;
    const Rgb white = whiteAtOrigin(scene);
    EXPECT_NEAR(0.6f * luminance(white), expected, 1e-4 * expected) << angle;
  }
}

}  // namespace
}  // namespace saccade
