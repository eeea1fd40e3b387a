// The light of a sun and of points without noise: pictures and changes against a formula.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "feed/feed.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

constexpr int kSize = 24;
constexpr float kHeight = 1, kStep = 0.01f, kAlbedo = 0.5f, kIrradiance = 4;

// Slats above a floor, in the sun that stands at an angle.
Scene slats() {
  Scene s = test::floorFromAbove(kAlbedo);
  s.directional_lights = {{normalize(Vec3{1, 0, -1}), {kIrradiance, kIrradiance, kIrradiance}}};
  for (int i = -20; i < 20; ++i)
    s.meshes.push_back(test::quad({static_cast<float>(i) * 0.1f, -5, kHeight}, {0.05f, 0, 0}, {0, 10, 0}, 0));
  s.T_world_camera.position = {0, 0, 0.8};
  s.fov_x_deg = 40;
  return s;
}

// Light that the floor reflects at x.
double lightAt(double x) {
  const double slat = (x - kHeight) / 0.1;  // where the ray from the sun has passed
  const bool dark = slat - std::floor(slat) < 0.5;
  return dark ? 0 : kAlbedo * kIrradiance * std::sqrt(0.5) / std::numbers::pi;
}
// How near x is to the edge of a shadow.
double fromEdge(double x) {
  const double place = (x - kHeight) / 0.05;
  return std::abs(place - std::round(place)) * 0.05;
}

FeedConfig config() {
  FeedConfig c;
  c.camera = pinhole(40, kSize, kSize), c.frame_rate_hz = 100, c.bounces = 0;
  c.method = "irradiance_cache";
  std::string name;
  EXPECT_EQ(resolveParams(*findMethod(c.method), {}, c.params, name), "");
  return c;
}

TEST(ExactLight, OfASunIsThatOfEachPixel) {
  TilePool pool(2);
  const Scene scene = slats();
  const Pose home = scene.T_world_camera;
  Pose there = home;
  there.position.x += 100 * kStep;
  const Trajectory path({{TimeNs(0), home}, {TimeNs(1'000'000'000), there}});
  Feed feed(std::make_shared<RenderScene>(scene), path, config(), pool);
  int lit = 0, dark = 0;
  for (int frame = 1; frame <= 3; ++frame) {
    const IntensityChange& change = feed.step(pool);
    for (int x = 0; x < kSize; ++x) {
      const double pixel = 2 * 0.8 * std::tan(20 * std::numbers::pi / 180) / kSize;
      const double before = (x + 0.5 - kSize / 2.) * pixel + kStep * (frame - 1), now = before + kStep;
      if (std::min(fromEdge(before), fromEdge(now)) < 1e-3) continue;
      EXPECT_NEAR(change.I_now.at(x, 5), lightAt(now), 1e-5) << x;
      EXPECT_NEAR(change.dI.at(x, 5), lightAt(now) - lightAt(before), 1e-5) << x;
      ++(lightAt(now) > 0 ? lit : dark);
    }
  }
  EXPECT_GT(lit, kSize);
  EXPECT_GT(dark, kSize / 2);
}

// A lamp above a black floor with a smooth coat, which mirrors it. The reflectance is that of a right angle
// to 1 %: the camera looks down.
TEST(ExactLight, OfALampInACoatIsThatOfEachPixel) {
  constexpr float kRadiance = 4, kWide = 0.1f;
  TilePool pool(2);
  Scene scene = test::floorFromAbove(0);
  scene.materials[0].model.kind = BsdfKind::kPlastic, scene.materials[0].model.ior = 1.5f;
  const Rgb radiance{kRadiance, kRadiance, kRadiance};
  scene.meshes.push_back(test::quad({-kWide, -5, 1}, {0, 10, 0}, {2 * kWide, 0, 0}, 0, radiance));
  scene.T_world_camera.position = {0, 0, 0.8};
  const Pose home = scene.T_world_camera;
  Pose there = home;
  there.position.x += 100 * kStep;
  const Trajectory path({{TimeNs(0), home}, {TimeNs(1'000'000'000), there}});
  FeedConfig narrow = config();
  narrow.camera = pinhole(20, kSize, kSize);
  Feed feed(std::make_shared<RenderScene>(scene), path, narrow, pool);
  const double pixel = 2 * std::tan(10 * std::numbers::pi / 180) / kSize;
  int gone = 0;
  for (int frame = 1; frame <= 3; ++frame) {
    const IntensityChange& change = feed.step(pool);
    for (int x = 0; x < kSize; ++x) {
      const auto mirrored = [&](int f) {
        return std::abs(kStep * f + (x + 0.5 - kSize / 2.) * pixel * (0.8 + 1));
      };
      const auto light = [&](int f) { return mirrored(f) < kWide ? 0.04 * kRadiance : 0; };
      if (std::min(std::abs(mirrored(frame) - kWide), std::abs(mirrored(frame - 1) - kWide)) < 1e-3) continue;
      EXPECT_NEAR(change.I_now.at(x, kSize / 2), light(frame), 1e-2 * 0.04 * kRadiance) << x;
      EXPECT_NEAR(change.dI.at(x, kSize / 2), light(frame) - light(frame - 1), 1e-2 * 0.04 * kRadiance) << x;
      gone += light(frame) < light(frame - 1);
    }
  }
  EXPECT_GT(gone, 0);
}

// A mask covers half of a pixel, and lets a part of the floor be seen. Its shadow falls outside the view.
TEST(ExactLight, OfMasksIsTheirMeanOverThePixel) {
  constexpr float kMaskAlbedo = 0.8f;
  TilePool pool(2);
  for (const float opacity : {0.f, 0.3f, 1.f}) {
    Scene scene = test::floorFromAbove(kAlbedo);
    scene.directional_lights = {{normalize(Vec3{1, 0, -1}), {kIrradiance, kIrradiance, kIrradiance}}};
    scene.materials.push_back(test::grey(kMaskAlbedo));
    scene.materials[1].opacity.color0 = {opacity, opacity, opacity};
    scene.meshes.push_back(test::quad({0, -5, 1}, {5, 0, 0}, {0, 10, 0}, 1));
    FeedConfig one = config();
    one.camera = pinhole(scene.fov_x_deg, 1, 1), one.jitter = true;
    const Trajectory standing({{TimeNs(0), scene.T_world_camera}});
    Feed feed(std::make_shared<RenderScene>(scene), standing, one, pool);
    const float albedo = 0.5f * (opacity * kMaskAlbedo + (1 - opacity) * kAlbedo) + 0.5f * kAlbedo;
    const double light = kIrradiance * std::sqrt(0.5) / std::numbers::pi;
    EXPECT_NEAR(feed.step(pool).I_now.at(0, 0), albedo * light, 1e-4) << opacity;
  }
}

}  // namespace
}  // namespace saccade
