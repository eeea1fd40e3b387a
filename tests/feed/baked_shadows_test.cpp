// Shadows that are narrower than the cells of a bake: on a floor under a small lamp that a card covers in
// part.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "feed/baker.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;

constexpr int kW = 64, kH = 24, kFrames = 12;
constexpr double kHalf = 0.003, kLamp = 2e5;  // half of an edge of the lamp, and its radiance
constexpr double kEye = 0.9, kFov = 14, kAlbedo = 0.5;
constexpr double kPixel = 2 * kEye * 0.12278456 / kW;  // on the floor: tan(7 degrees)
constexpr double kStep = 0.67 * kPixel;                // from frame to frame

// The lamp is at height 2, and the card at height 1 ends at x = 0. The penumbra is as wide as the lamp: less
// than two pixels.
std::shared_ptr<const RenderScene> cardUnderASmallLamp(bool card = true) {
  constexpr auto s = static_cast<float>(kHalf), radiance = static_cast<float>(kLamp);
  Scene scene = test::floorFromAbove(kAlbedo);
  scene.meshes.push_back(
      test::quad({-s, -s, 2}, {0, 2 * s, 0}, {2 * s, 0, 0}, 0, {radiance, radiance, radiance}));
  if (card) scene.meshes.push_back(test::quad({-4, -60, 1}, {4, 0, 0}, {0, 120, 0}, 0));
  return std::make_shared<RenderScene>(std::move(scene));
}

Trajectory path(double end = kFrames * kStep) {
  const Pose begin{{0, 0, kEye}, {1, 0, 0, 0}}, last{{end, 0, kEye}, {1, 0, 0, 0}};
  return Trajectory({{0ms, begin}, {10ms * kFrames, last}});
}

FeedConfig config() {
  FeedConfig c;
  c.camera = pinhole(kFov, kW, kH), c.frame_rate_hz = 100, c.method = "irradiance_cache", c.bounces = 0;
  std::string name;
  EXPECT_EQ(resolveParams(*findMethod(c.method), {}, c.params, name), "");
  return c;
}

FeedConfig baked(const std::shared_ptr<const RenderScene>& scene, const Trajectory& along, TilePool& pool) {
  FeedConfig with = config();
  Baker baker(scene, planBake(*scene, along, with, kFrames, 0.02));
  while (!baker.isDone()) baker.pass(pool);
  with.baked = baker.light(pool);
  return with;
}

// The light of a floor point: that of a lamp so small, by the share of it that is seen past the card.
double lightAt(double x, double y) {
  const double d2 = x * x + y * y + 4, cosine = 2 / std::sqrt(d2);
  const double all = kLamp * 4 * kHalf * kHalf * cosine * cosine / d2;
  return kAlbedo * std::numbers::inv_pi * all * std::clamp((kHalf + x) / (2 * kHalf), 0., 1.);
}

double xOf(int pixel, double camera) {
  return camera + (pixel + 0.5 - kW / 2.) * kPixel;
}

int raysOf(const Feed& feed) {
  const SurfaceSamples& on = *feed.frames().cur.surfaces;
  int rays = 0;
  for (int y = 0; y < kH; ++y)
    for (int x = 0; x < kW; ++x) rays += on.wantsShadows(x, y);
  return rays;
}

struct BakedShadows : testing::Test {
  TilePool pool{2};
};

TEST_F(BakedShadows, AreAsSharpAsTheyAre) {
  const auto scene = cardUnderASmallLamp();
  Feed feed(scene, path(), baked(scene, path(), pool), pool);
  double squares = 0, truth = 0;
  for (int t = 1; t < kFrames; ++t) {
    const IntensityChange& change = feed.step(pool);
    for (int y = 0; y < kH; ++y)
      for (int x = 0; x < kW; ++x) {
        const auto light = [&](int frame) {
          return lightAt(xOf(x, frame * kStep), (y + 0.5 - kH / 2.) * kPixel);
        };
        const double true_change = light(t) - light(t - 1);
        squares += std::pow(change.dI.at(x, y) - true_change, 2), truth += true_change * true_change;
      }
    EXPECT_GT(raysOf(feed), 2 * kH) << t;
    EXPECT_LT(raysOf(feed), kW * kH / 2) << t;
  }
  EXPECT_LT(std::sqrt(squares / truth), 0.32);
}

TEST_F(BakedShadows, AStandingCameraSeesNoChange) {
  const auto scene = cardUnderASmallLamp();
  const Trajectory stands = path(0);
  Feed feed(scene, stands, baked(scene, stands, pool), pool);
  for (int t = 1; t < 6; ++t) {
    const IntensityChange& change = feed.step(pool);
    if (t > 1) {
      EXPECT_GT(raysOf(feed), 0) << t;
    }
    for (int y = 0; y < kH; ++y)
      for (int x = 0; x < kW; ++x) ASSERT_EQ(change.dI.at(x, y), 0) << t << " " << x << " " << y;
  }
}

TEST_F(BakedShadows, AskForNoRaysWhereNothingCastsOne) {
  const auto scene = cardUnderASmallLamp(false);
  Feed feed(scene, path(), baked(scene, path(), pool), pool);
  for (int t = 1; t < kFrames; ++t) {
    feed.step(pool);
    EXPECT_EQ(raysOf(feed), 0) << t;
  }
}

TEST_F(BakedShadows, AreTheSameForAnyNumberOfThreads) {
  const auto scene = cardUnderASmallLamp();
  const FeedConfig with = baked(scene, path(), pool);
  TilePool one(1), three(3);
  Feed a(scene, path(), with, one), b(scene, path(), with, three);
  for (int t = 1; t < 6; ++t) {
    const IntensityChange &x = a.step(one), &y = b.step(three);
    for (int row = 0; row < kH; ++row)
      for (int column = 0; column < kW; ++column) {
        ASSERT_EQ(x.dI.at(column, row), y.dI.at(column, row));
        ASSERT_EQ(x.var_dI.at(column, row), y.var_dI.at(column, row));
      }
  }
}

}  // namespace
}  // namespace saccade
