// Pairs of paths with common numbers in two frames.
#include <gtest/gtest.h>

#include "render/renderer.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

constexpr int kSize = 20;

// A floor of brushed metal, half of it diffuse, under a lamp and beside a wall.
Scene metalRoom() {
  Scene s;
  Material metal = test::grey(0.5f);
  metal.model.kind = BsdfKind::kRoughConductor, metal.model.alpha = 0.2f;
  s.materials = {metal, test::grey(0.6f)};
  s.meshes = {test::quad({-2, -2, 0}, {2.5f, 0, 0}, {0, 4, 0}, 0),
              test::quad({0.5f, -2, 0}, {1.5f, 0, 0}, {0, 4, 0}, 1),
              test::quad({-2, -2, 0}, {0, 4, 0}, {0, 0, 4}, 1),
              test::quad({1, -0.3f, 3.5f}, {0, 0.6f, 0}, {0.6f, 0, 0}, 1, {20, 20, 20})};
  s.T_world_camera = {{0, 0, 3}, {1, 0, 0, 0}};  // half a turn about x: looks down
  s.fov_x_deg = 50;
  return s;
}

struct TwoFrames {
  Frame before{kSize, kSize, 1}, now{kSize, kSize, 1};
};

// The camera moves by `step` to the right.
TwoFrames render(double step, std::uint32_t paths, int threads = 2) {
  const Scene scene = metalRoom();
  const PosedScene posed(std::make_shared<RenderScene>(scene));
  TilePool pool(threads);
  Pose moved = scene.T_world_camera;
  moved.position.x += step;
  const CameraModel lens = pinhole(scene.fov_x_deg, kSize, kSize);
  const Camera first(scene.T_world_camera, lens), second(moved, lens);
  Renderer renderer({2, 1});
  TwoFrames frames;
  const auto renderOne = [&](const PixelContext& view, FrameIndex t, Frame& out) {
    const SurfaceFrame next = renderer.renderSurfaces(view, pool, out);
    for (int y = 0; y < kSize; ++y)
      for (SurfacePoint& p : out.surfaces->row(y)) p.paths = paths;
    renderer.renderPaths(view.now, SeedPlan::independent(1, t, 2), next, nullptr, pool);
  };
  renderOne(PixelContext({posed, first}), 0, frames.before);
  const PixelContext view({posed, second}, {posed, first});
  renderOne(view, 1, frames.now);
  renderer.renderPairs(view, SeedPlan::independent(1, 1, 2), frames.before, nullptr, pool, frames.now);
  return frames;
}

// Over the pixels with pairs.
template <class F>
double meanOfPaired(const TwoFrames& frames, const F& f) {
  double sum = 0, n = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x)
      if (frames.now.pairs->count.at(x, y) > 0) sum += f(x, y), n += 1;
  return sum / n;
}

TEST(Pairs, ArePixelsThatShowMetalInBothFrames) {
  const TwoFrames frames = render(0.2, 2);
  int with = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const bool both =
          frames.now.surfaces->hasUncacheable(x, y) && frames.before.surfaces->hasUncacheable(x, y);
      const float count = frames.now.pairs->count.at(x, y);
      EXPECT_EQ(count, both ? 2 + frames.now.pairs->more.at(x, y) : 0);
      with += both;
    }
  EXPECT_GT(with, kSize * kSize / 3);
  EXPECT_LT(with, kSize * kSize);
}

// The same numbers at the same surfaces are the same paths.
TEST(Pairs, OfACameraThatStandsAreEqual) {
  const TwoFrames frames = render(0, 2);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x)
      if (frames.now.pairs->count.at(x, y) > 0) {
        EXPECT_EQ(frames.now.pairs->before.at(x, y), frames.now.samples.I2.at(x, y)) << x << ' ' << y;
      }
}

// A replay is an estimate of the frame before, as that frame's own paths are, and its noise is that of this
// frame. So the mean is that of the frame before, and the change has far less noise than that of two frames.
TEST(Pairs, EstimateTheFrameBeforeWithTheNoiseOfThisOne) {
  const TwoFrames few = render(0.01, 2), many = render(0.01, 512);
  const auto before = [&](int x, int y) { return double{many.before.samples.I2.at(x, y)}; };
  const double mean = meanOfPaired(many, before);
  EXPECT_NEAR(meanOfPaired(many, [&](int x, int y) { return many.now.pairs->before.at(x, y); }), mean,
              0.01 * mean);
  const double paired = meanOfPaired(few, [&](int x, int y) {
    return std::abs(few.now.samples.I2.at(x, y) - few.now.pairs->before.at(x, y));
  });
  const double apart = meanOfPaired(few, [&](int x, int y) {
    return std::abs(few.now.samples.I2.at(x, y) - few.before.samples.I2.at(x, y));
  });
  EXPECT_LT(paired, 0.25 * apart);
}

TEST(Pairs, AreTheSameForAnyNumberOfThreads) {
  const TwoFrames one = render(0.1, 1, 1);
  for (const int threads : {2, 5}) {
    const TwoFrames other = render(0.1, 1, threads);
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        ASSERT_EQ(one.now.samples.I2.at(x, y), other.now.samples.I2.at(x, y));
        ASSERT_EQ(one.now.pairs->before.at(x, y), other.now.pairs->before.at(x, y));
        ASSERT_EQ(one.now.pairs->variance.at(x, y), other.now.pairs->variance.at(x, y));
      }
  }
}

}  // namespace
}  // namespace saccade
