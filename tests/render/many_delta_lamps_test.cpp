// More lamps without extent than get a ray each, against pictures in which each gets one.
#include <gtest/gtest.h>

#include <cmath>

#include "base/hash_rng.h"
#include "render/renderer.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

constexpr int kWidth = 48, kHeight = 36;
constexpr std::size_t kLamps = 64;

float u(std::uint32_t i) {
  return toUnit(mix32(i + 1));
}

void addRoom(Scene& s, float x) {
  for (Mesh& wall : test::furnace(0.6f, 0).meshes) {
    for (Vec3& p : wall.positions) p.x += x;
    s.meshes.push_back(wall);
  }
}

// Two closed rooms, side by side. The camera stands in the one about the origin, where a ball casts shadows.
// The first lamps are here, all others in the other room, or as faint as is said.
Scene rooms(std::size_t here, bool others_here, float faint) {
  Scene s = test::furnace(0.6f, 0);
  addRoom(s, 2.2f);
  s.spheres = {{"ball", {0.2f, -0.3f, -0.5f}, 0.3f, 0, {}}};
  for (std::uint32_t i = 0; i < kLamps; ++i) {
    const bool far = i >= here && !others_here;
    const Vec3 at{1.6f * u(3 * i) - 0.8f + (far ? 2.2f : 0), 0.2f + 0.7f * u(3 * i + 1),
                  1.6f * u(3 * i + 2) - 0.8f};
    s.point_lights.push_back({at, Rgb{1, 1, 1} * (i < here || far ? 1 : faint)});
  }
  return s;
}

ImageF directLight(const Scene& scene, double x) {
  const PosedScene posed(std::make_shared<RenderScene>(scene));
  TilePool pool(2);
  Renderer renderer({0, 1});
  FrameRing frames(kWidth, kHeight, 1);
  Pose pose = scene.T_world_camera;
  pose.position.x = x;
  const Camera camera(pose, pinhole(scene.fov_x_deg, kWidth, kHeight));
  frames.swap();
  renderer.renderSurfaces(PixelContext({posed, camera}, {posed, camera}), pool, frames.current());
  return std::move(frames.current().g.emission);
}

// Sixteen at a time get a ray each.
ImageF exactLight(const Scene& scene, double x) {
  ImageF sum(kWidth, kHeight);
  for (std::size_t first = 0; first < kLamps; first += 16) {
    Scene part = scene;
    const auto begin = scene.point_lights.begin() + static_cast<std::ptrdiff_t>(first);
    part.point_lights.assign(begin, begin + 16);
    const ImageF light = directLight(part, x);
    for (int y = 0; y < kHeight; ++y)
      for (int i = 0; i < kWidth; ++i) sum.at(i, y) += light.at(i, y);
  }
  return sum;
}

// Of the change from one place of the camera to the next, and of the light.
struct Errors {
  double change, light;
};
Errors errorsOf(const Scene& scene) {
  const double from = 0.01, to = 0.02;
  const ImageF a = directLight(scene, from), b = directLight(scene, to);
  const ImageF exact_a = exactLight(scene, from), exact_b = exactLight(scene, to);
  double change = 0, changes = 0, light = 0, lights = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const double truth = exact_b.at(x, y) - exact_a.at(x, y);
      change += std::abs(b.at(x, y) - a.at(x, y) - truth), changes += std::abs(truth);
      light += std::abs(b.at(x, y) - exact_b.at(x, y)), lights += exact_b.at(x, y);
    }
  return {change / changes, light / lights};
}

// Few lamps are summed in lanes, which rounds otherwise.
TEST(ManyDeltaLamps, ThoseOfAnotherRoomDoNoHarm) {
  const Errors errors = errorsOf(rooms(4, false, 0));
  EXPECT_LT(errors.change, 1e-5);
  EXPECT_LT(errors.light, 1e-7);
}

TEST(ManyDeltaLamps, FaintOnesDoLittleHarm) {
  const Errors errors = errorsOf(rooms(4, true, 1e-3f));
  EXPECT_LT(errors.change, 1e-3);
  EXPECT_LT(errors.light, 1e-4);
}

// A quarter of them get a ray each, and sixteen rays stand for all others.
TEST(ManyDeltaLamps, ErrLittleWhereAllMatter) {
  const Errors errors = errorsOf(rooms(kLamps, true, 1));
  EXPECT_GT(errors.light, 0);
  EXPECT_LT(errors.change, 0.03);
  EXPECT_LT(errors.light, 0.002);
}

TEST(ManyDeltaLamps, AStandingCameraSeesNoChange) {
  const Scene scene = rooms(20, false, 0);
  const ImageF a = directLight(scene, 0.01), b = directLight(scene, 0.01);
  double sum = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      ASSERT_EQ(a.at(x, y), b.at(x, y));
      sum += a.at(x, y);
    }
  EXPECT_GT(sum, 1);
}

}  // namespace
}  // namespace saccade
