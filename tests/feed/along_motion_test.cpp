// Paths keep the numbers of the surface that they start at.
#include <gtest/gtest.h>

#include <cmath>

#include "feed/feed.h"
#include "frame/pixel_before.h"
#include "methods/path_traced.h"
#include "render/test_scenes.h"
#include "render/tiles/along_motion.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;
constexpr int kSize = 16;

// A floor below a lamp of a tenth of its width. The camera moves by `pixels` in every frame, 2.5 to 3.4.
double largestDifference(SeedPlanner seeds, double pixels) {
  Scene s = test::floorFromAbove(0.5f);
  s.meshes.push_back(test::quad({-0.5f, -0.5f, 3.5f}, {0, 1, 0}, {1, 0, 0}, 0, {9, 9, 9}));
  const Pose begin = s.T_world_camera;
  const double pixel = 2 * 3 * std::tan(s.fov_x_deg / 2 * std::numbers::pi / 180) / kSize;
  const Pose end = begin * Pose{{pixels * pixel, 0, 0}, {}};
  FeedConfig config;
  config.camera = pinhole(s.fov_x_deg, kSize, kSize), config.frame_rate_hz = 1000;
  config.bounces = 0;
  TilePool pool(2);
  Feed feed(std::make_shared<RenderScene>(std::move(s)), Trajectory({{0ms, begin}, {1ms, end}}), config,
            std::make_unique<PathTraced>(true), seeds, pool);
  feed.step(pool);
  const auto [cur, prev] = std::pair<const Frame&, const Frame&>(feed.frames().cur, feed.frames().prev);
  double largest = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize - 3; ++x) {
      const PixelPlace p = pixelBefore(cur.g, x, y);
      EXPECT_EQ(p.x, x + 3);
      EXPECT_GT(cur.samples.I1.at(x, y), 0);
      largest =
          std::max<double>(largest, std::abs(cur.samples.I1.at(x, y) / prev.samples.I2.at(p.x, p.y) - 1));
    }
  }
  return largest;
}

// By hand: x = 2 has come from 4.3, so that the centre of pixel 4 is now at 1.7. A surface from outside the
// picture, and a motion that is no number, lead to the pixel itself.
TEST(AlongMotion, APointThatWasInThePictureIsWithinHalfAPixel) {
  GBuffer g(8, 8);
  g.motion_x.fill(2.3f), g.motion_y.fill(-0.4f);
  EXPECT_NEAR(placeOfBefore(g, 2, 3).x, 1.7, 1e-5);
  EXPECT_NEAR(placeOfBefore(g, 2, 3).y, 3.4, 1e-5);
  EXPECT_EQ(placeOfBefore(g, 7, 3).x, 7);
  g.motion_x.fill(std::nanf(""));
  EXPECT_EQ(placeOfBefore(g, 2, 3).x, 2);
}

// Pass 1 starts where pass 2 did, wherever in a pixel that point has come to.
TEST(AlongMotion, PassOneRepeatsTheSamplesOfEachSurface) {
  for (const double pixels : {3.0, 2.6, 3.4}) {
    EXPECT_LT(largestDifference(SeedPlan::correlatedAlongMotion, pixels), 1e-3) << pixels;
    EXPECT_GT(largestDifference(SeedPlan::correlated, pixels), 0.05) << pixels;
  }
}

}  // namespace
}  // namespace saccade
