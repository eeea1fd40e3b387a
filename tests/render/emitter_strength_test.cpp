// Emitters whose strength changes over time: what a frame shows of it.
#include <gtest/gtest.h>

#include <cmath>

#include "render/renderer.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;

constexpr int kSize = 24;

// A floor seen from above, lit by a panel beside the picture and by a ball in the middle of it.
Scene lamps(Rgb panel, Rgb ball) {
  Scene s = test::floorFromAbove(0.6f);
  s.meshes.push_back(test::quad({2, -1, 0.1f}, {0, 0, 1}, {0, 2, 0}, 0, panel));
  s.spheres.push_back({"ball", {0, 0, 0.8f}, 0.4f, 0, ball});
  s.fov_x_deg = 60;
  return s;
}

const SeedPlan kSeeds = SeedPlan::correlated(7, 5, 4);

Frame render(const Scene& scene, TimeNs time, const SeedPlan& seeds = kSeeds, int channels = 1) {
  PosedScene posed(std::make_shared<RenderScene>(scene));
  posed.setTime(time);
  TilePool pool(2);
  Frame frame(kSize, kSize);
  const Camera camera(scene.T_world_camera, pinhole(scene.fov_x_deg, kSize, kSize));
  Renderer({2, channels}).render(PixelContext({posed, camera}), seeds, pool, frame);
  return frame;
}

// f(a, b) holds at every pixel.
template <class F>
void forEach(const ImageF& a, const ImageF& b, F f) {
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) f(a.at(x, y), b.at(x, y));
}

// A power of two scales every sum without rounding.
void expectScaled(const Frame& now, const Frame& before, float factor) {
  const auto scaled = [&](float a, float b) { ASSERT_EQ(a, factor * b); };
  forEach(now.samples.I1, before.samples.I1, scaled);
  forEach(now.samples.I2, before.samples.I2, scaled);
  forEach(now.g.emission, before.g.emission, scaled);
}

TEST(EmitterStrength, ScalesThePictureAndTheEmissionAtTheTimeOfTheFrame) {
  Scene scene = lamps({}, {5, 3, 2});
  scene.spheres[0].strength = Strength({{0ms, 1}, {10ms, 1}, {10ms, 0.25f}});
  for (const int channels : {1, 3}) {
    const Frame before = render(scene, 10ms - 1ns, kSeeds, channels);
    EXPECT_FLOAT_EQ(before.g.emission.at(kSize / 2, kSize / 2), luminance({5, 3, 2}));
    EXPECT_GT(before.samples.I1.at(0, 0), 0);
    expectScaled(render(scene, 10ms, kSeeds, channels), before, 0.25f);
  }
}

TEST(EmitterStrength, OfAStillIsThatAtTheTimeOfItsFrame) {
  Scene scene = lamps({}, {5, 3, 2});
  scene.spheres[0].strength = Strength({{0ms, 1}, {10ms, 0.25f}});
  const auto s = std::make_shared<RenderScene>(scene);
  const Camera camera(scene.T_world_camera, pinhole(scene.fov_x_deg, kSize, kSize));
  TilePool pool(2);
  Renderer renderer({1, 3});
  const auto green = [&](TimeNs time) {
    Frame frame(kSize, kSize);
    PosedScene posed(s);
    posed.setTime(time);
    ImageF rgb[3] = {{kSize, kSize}, {kSize, kSize}, {kSize, kSize}};
    renderer.renderStill(PixelContext({posed, camera}), SeedPlan::independent(7, 0, 2), pool, frame, rgb);
    return std::move(rgb[1]);
  };
  const ImageF first = green(0ms), later = green(10ms);
  EXPECT_GE(first.at(kSize / 2, kSize / 2), 3);
  forEach(later, first, [](float a, float b) { ASSERT_EQ(a, 0.25f * b); });
}

// [E (8)]: the change is exactly what the lamp lost.
TEST(EmitterStrength, ChangesCorrelatedFramesByTheFactorAlone) {
  Scene scene = lamps({}, {5, 3, 2});
  scene.spheres[0].strength = Strength({{0ms, 1}, {10ms, 1}, {10ms, 0.25f}});
  const Frame before = render(scene, 8ms, SeedPlan::correlated(7, 4, 2));
  const Frame now = render(scene, 10ms, SeedPlan::correlated(7, 5, 2));
  EXPECT_GT(before.samples.I2.at(0, 0), 0);
  forEach(now.samples.I1, before.samples.I2,
          [](float I1, float I2_prev) { ASSERT_EQ(I1 - I2_prev, -0.75f * I2_prev); });
}

TEST(EmitterStrength, FlickersForEver) {
  Scene scene = lamps({4, 4, 4}, {});
  scene.meshes[1].strength = Strength::periodic({{0ms, 1}, {5ms, 1}, {5ms, 0.5f}}, 10ms);
  const Frame on = render(scene, 0ms);
  EXPECT_GT(on.samples.I2.at(0, 0), 0);
  expectScaled(render(scene, 5ms), on, 0.5f);
  expectScaled(render(scene, 1'000ms), on, 1);
  expectScaled(render(scene, 1'005ms), on, 0.5f);
}

TEST(EmitterStrength, OfZeroIsDarkness) {
  Scene scene = lamps({}, {5, 5, 5});
  scene.spheres[0].strength = Strength({{0ms, 0}});
  const Frame dark = render(scene, 0ms);
  forEach(dark.samples.I1, dark.samples.I2, [](float a, float b) { ASSERT_TRUE(a == 0 && b == 0); });
  forEach(dark.g.emission, dark.g.emission, [](float e, float) { ASSERT_EQ(e, 0); });
}

// The same seeds find the same points on the lamps, however strong these are: the picture is linear in the
// strengths, path by path.
TEST(EmitterStrength, LeavesThePathsAlone) {
  Scene scene = lamps({4, 4, 4}, {5, 5, 5});
  scene.meshes[1].strength = Strength({{0ms, 1}, {1ms, 0}, {2ms, 3}});
  scene.spheres[0].strength = Strength({{0ms, 0}, {1ms, 1}, {2ms, 0.5f}});
  const Frame panel = render(scene, 0ms), ball = render(scene, 1ms), both = render(scene, 2ms);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const float sum = 3 * panel.samples.I2.at(x, y) + 0.5f * ball.samples.I2.at(x, y);
      ASSERT_NEAR(both.samples.I2.at(x, y), sum, 1e-5f * sum);
    }
  }
}

// Against lamps rendered one by one, as they would be chosen and weighted alone.
TEST(EmitterStrength, IsTheSumOfLampsRenderedAlone) {
  Scene scene = lamps({4, 4, 4}, {5, 5, 5});
  scene.meshes[1].strength = Strength({{0ms, 3}});
  scene.spheres[0].strength = Strength({{0ms, 0.5f}});
  const auto seeds = [](FrameIndex t) { return SeedPlan::independent(7, t, 256); };
  const ImageF both = render(scene, 0ms, seeds(1)).samples.I2;
  const ImageF panel = render(lamps({4, 4, 4}, {}), 0ms, seeds(2)).samples.I2;
  const ImageF ball = render(lamps({}, {5, 5, 5}), 0ms, seeds(3)).samples.I2;
  double sum = 0, difference = 0, square = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const double expected = 3 * panel.at(x, y) + 0.5 * ball.at(x, y), d = both.at(x, y) - expected;
      sum += expected, difference += d, square += d * d;
    }
  }
  EXPECT_LT(std::abs(difference), 4 * std::sqrt(square));  // standard error of a sum of independent pixels
  EXPECT_LT(std::sqrt(square), 4e-3 * sum);
}

}  // namespace
}  // namespace saccade
