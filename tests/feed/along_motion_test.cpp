// Paths keep the numbers of the surface that they start at.
#include <gtest/gtest.h>

#include "feed/feed.h"
#include "frame/pixel_before.h"
#include "methods/path_traced.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;
constexpr int kSize = 16;

// A floor below a lamp of a tenth of its width. The camera moves by three pixels in every frame.
double largestDifference(SeedPlanner seeds) {
  Scene s = test::floorFromAbove(0.5f);
  s.meshes.push_back(test::quad({-0.5f, -0.5f, 3.5f}, {0, 1, 0}, {1, 0, 0}, 0, {9, 9, 9}));
  const Pose begin = s.T_world_camera;
  const double pixel = 2 * 3 * std::tan(s.fov_x_deg / 2 * std::numbers::pi / 180) / kSize;
  const Pose end = begin * Pose{{3 * pixel, 0, 0}, {}};
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

// Motion by whole pixels brings the same points back to pixel centres.
TEST(AlongMotion, PassOneRepeatsTheSamplesOfEachSurface) {
  EXPECT_LT(largestDifference(SeedPlan::correlatedAlongMotion), 1e-3);
  EXPECT_GT(largestDifference(SeedPlan::correlated), 0.05);
}

}  // namespace
}  // namespace saccade
