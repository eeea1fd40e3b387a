// Paths that start all over the pixel.
#include <gtest/gtest.h>

#include "render/primary/sub_pixel.h"
#include "render/render_mean.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

constexpr int kSize = 16;
constexpr RenderSettings kCentre{1, 1}, kJittered{1, 1, true};

// A floor of squares about as large as a pixel, half 0.2 and half 0.8, lit evenly, so that it returns its
// albedo.
Scene squares() {
  Scene s = test::floorFromAbove(0.5f);
  std::vector<Rgb> fine;
  for (int i = 0; i < 64 * 64; ++i)
    fine.push_back(Rgb{1, 1, 1} * (hashKey(5, static_cast<std::uint64_t>(i)) & 1 ? 0.2f : 0.8f));
  s.textures.emplace_back(64, 64, fine);
  s.materials[0].reflectance.kind = SurfaceColor::Kind::kBitmap;
  s.materials[0].reflectance.texture = 0;
  s.directional_lights = {{{0, 0, -1}, Rgb{1, 1, 1} * std::numbers::pi_v<float>}};
  s.fov_x_deg = 60;
  return s;
}

double variance(const ImageF& image) {
  const double error = test::meanOf(image).error;
  return error * error;
}

TEST(SubPixels, AreHaltonsPointsAboutTheCentre) {
  EXPECT_FLOAT_EQ(halton(1, 2), 0.5f);
  EXPECT_FLOAT_EQ(halton(6, 2), 3.f / 8);
  EXPECT_FLOAT_EQ(halton(5, 3), 7.f / 9);
  Vec2 mean;
  for (const Vec2 p : kSubPixelOffsets) {
    EXPECT_LT(std::max(std::abs(p.x), std::abs(p.y)), 0.5f);
    mean.x += p.x, mean.y += p.y;
  }
  EXPECT_NEAR(mean.x, 0, 1e-6);
  EXPECT_NEAR(mean.y, 0, 1e-6);
}

// Illumination is the same all over the pixel: each pass has it off the average albedo, whatever its place.
TEST(Jitter, LeavesOnlyTheAverageAlbedoOfFineTexture) {
  const Frame frame = test::renderFrame(squares(), SeedPlan::correlated(3, 5, 2), kJittered, kSize);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      ASSERT_NEAR(frame.samples.I1.at(x, y), frame.g.albedo.at(x, y), 1e-4f);
      ASSERT_NEAR(frame.samples.I2.at(x, y), frame.g.albedo.at(x, y), 1e-4f);
    }
  }
  const Frame centre = test::renderFrame(squares(), SeedPlan::correlated(3, 5, 2), kCentre, kSize);
  EXPECT_LT(variance(frame.g.albedo), 0.8 * variance(centre.g.albedo));
}

TEST(Jitter, PassOneReplaysThePlaceOfThePreviousFrame) {
  Scene room = test::furnace(0.6f, 0);
  room.meshes.push_back(test::quad({-0.3f, -0.95f, -0.3f}, {0, 0, 0.6f}, {0.6f, 0, 0}, 0, {9, 9, 9}));
  const Frame before = test::renderFrame(room, SeedPlan::correlated(7, 4, 2), kJittered, kSize);
  const Frame after = test::renderFrame(room, SeedPlan::correlated(7, 5, 2), kJittered, kSize);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) ASSERT_EQ(after.samples.I1.at(x, y), before.samples.I2.at(x, y));
  }
}

// A mask of opacity 0.3 over a floor. The sun stands so low that the floor in view lies in no shadow.
Scene thinMask() {
  Scene s = test::floorFromAbove(0.5f);
  s.materials.push_back(test::grey(0.8f));
  s.materials[1].opacity.color0 = {0.3f, 0.3f, 0.3f};
  s.meshes.push_back(test::quad({-0.5f, -5, 1}, {1, 0, 0}, {0, 10, 0}, 1));
  s.directional_lights = {{normalize(Vec3{1, 0, -1}), {4, 4, 4}}};
  return s;
}

TEST(Jitter, MasksAreMeansOfWhatTheyShow) {
  const Frame frame = test::renderFrame(thinMask(), SeedPlan::correlated(3, 5, 2), kJittered, kSize);
  const float albedo = 0.3f * 0.8f + 0.7f * 0.5f, light = 4 * std::sqrt(0.5f) / std::numbers::pi_v<float>;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      ASSERT_NEAR(frame.g.albedo.at(x, y), albedo, 1e-5f);
      ASSERT_NEAR(frame.samples.I1.at(x, y), albedo * light, 1e-4f);
      ASSERT_NEAR(frame.samples.I2.at(x, y), albedo * light, 1e-4f);
    }
  }
}

TEST(Jitter, MasksDoNotThinWhatTheyEmit) {
  Scene scene = thinMask();
  scene.meshes[1].radiance = {2, 2, 2};
  const Frame frame = test::renderFrame(scene, SeedPlan::independent(1, 0, 2), kJittered, 1);
  EXPECT_NEAR(frame.g.emission.at(0, 0), 2, 1e-5);
}

// The edge of a lamp covers a part of a pixel.
TEST(Jitter, EmissionIsThatOfTheWholePixel) {
  Scene scene = test::floorFromAbove(0);
  scene.meshes.push_back(test::quad({0, -5, 0.1f}, {5, 0, 0}, {0, 10, 0}, 0, {2, 2, 2}));
  const Frame frame = test::renderFrame(scene, SeedPlan::independent(1, 0, 2), kJittered, 1);
  EXPECT_NEAR(frame.g.emission.at(0, 0), 1, 1e-5);  // two of four places
  EXPECT_EQ(frame.samples.I2.at(0, 0), frame.g.emission.at(0, 0));
}

}  // namespace
}  // namespace saccade
