#include "render/renderer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/camera/view_grid.h"
#include "render/render_pixels.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

constexpr int kW = 48, kH = 36;

// A room with a lamp and a ball.
Scene room() {
  Scene s = test::furnace(0.6f, 0);
  s.meshes.push_back(test::quad({-0.3f, -0.95f, -0.3f}, {0, 0, 0.6f}, {0.6f, 0, 0}, 0, {9, 9, 9}));
  s.spheres.push_back({"ball", {0.2f, 0.5f, 0.5f}, 0.4f, 0, {}});
  s.T_world_camera.position = {0, 0, -0.9};
  return s;
}

struct Fixture : ::testing::Test {
  std::shared_ptr<RenderScene> scene = std::make_shared<RenderScene>(room());
  Pose home = scene->description().T_world_camera;
  Camera cameraAt(double right) const { return {home * Pose{{right, 0, 0}, {}}, pinhole(80, kW, kH)}; }
  Frame render(const Camera& camera, const Camera& prev, const SeedPlan& seeds, int threads = 2) const {
    TilePool pool(threads);
    Frame frame(kW, kH);
    const PosedScene posed(scene);
    Renderer({3, 1}).render(PixelContext({posed, camera}, {posed, prev}), seeds, pool, frame);
    return frame;
  }
};

void expectEqual(const ImageF& a, const ImageF& b) {
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) ASSERT_EQ(a.at(x, y), b.at(x, y)) << x << "," << y;
  }
}

TEST_F(Fixture, PartsOfAPictureHaveItsPaths) {
  const Camera camera = cameraAt(0);
  SeedPlan part = SeedPlan::independent(1, 0, 4);
  part.all = 8;
  const Frame first = render(camera, camera, part),
              whole = render(camera, camera, SeedPlan::independent(1, 0, 8));
  part.before = 4;
  const Frame second = render(camera, camera, part);
  for (int y = 0; y < kH; ++y)
    for (int x = 0; x < kW; ++x) {
      const float mean = (first.samples.I2.at(x, y) + second.samples.I2.at(x, y)) / 2;
      ASSERT_NEAR(mean, whole.samples.I2.at(x, y), 1e-5f * (1 + mean)) << x << "," << y;
    }
}

// Whole tiles, runs of pixels and single ones.
TEST_F(Fixture, SomePixelsAreAsInTheWholePicture) {
  const Camera camera = cameraAt(0);
  const SeedPlan seeds = SeedPlan::independent(1, 0, 4);
  const Frame whole = render(camera, camera, seeds);
  Image<int> wanted(kW, kH);
  for (int y = 0; y < kH; ++y)
    for (int x = 0; x < kW; ++x) wanted.at(x, y) = x < 20 || (x < 40 ? x % 5 < 3 : (x + y) % 2);
  TilePool pool(2);
  Frame some(kW, kH);
  const PosedScene posed(scene);
  const float before = some.samples.I2.at(0, 0);
  renderPixels({3, 1}, PixelContext({posed, camera}, {posed, camera}), seeds, wanted, pool, some);
  for (int y = 0; y < kH; ++y)
    for (int x = 0; x < kW; ++x)
      ASSERT_EQ(some.samples.I2.at(x, y), wanted.at(x, y) ? whole.samples.I2.at(x, y) : before)
          << x << "," << y;
}

TEST_F(Fixture, PassOneReplaysTheSeedOfThePreviousFrame) {
  const Camera camera = cameraAt(0);
  const Frame before = render(camera, camera, SeedPlan::correlated(7, 4, 2));
  const Frame after = render(camera, camera, SeedPlan::correlated(7, 5, 2));
  expectEqual(after.samples.I1, before.samples.I2);
  EXPECT_NE(after.samples.I2.at(20, 20), before.samples.I2.at(20, 20));
}

TEST_F(Fixture, IsTheSameForAnyNumberOfThreads) {
  const Frame one = render(cameraAt(0.01), cameraAt(0), SeedPlan::correlated(7, 4, 2), 1);
  const Frame three = render(cameraAt(0.01), cameraAt(0), SeedPlan::correlated(7, 4, 2), 3);
  expectEqual(one.samples.I1, three.samples.I1);
  expectEqual(one.samples.I2, three.samples.I2);
  expectEqual(one.g.motion_x, three.g.motion_x);
}

// Why seeds are reused [E (8)]: small motion, far less variance of the difference.
TEST_F(Fixture, ReusedSeedsMakeTheDifferenceQuiet) {
  const Camera before = cameraAt(0), after = cameraAt(0.002);
  const Frame base = render(before, before, SeedPlan::independent(1, 4, 4));
  const Frame same = render(after, before, SeedPlan::independent(1, 4, 4));
  const Frame fresh = render(after, before, SeedPlan::independent(1, 5, 4));
  double correlated = 0, independent = 0;
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) {
      correlated += std::pow(same.samples.I2.at(x, y) - base.samples.I2.at(x, y), 2);
      independent += std::pow(fresh.samples.I2.at(x, y) - base.samples.I2.at(x, y), 2);
    }
  }
  EXPECT_LT(correlated, 0.1 * independent);
}

TEST_F(Fixture, MotionPointsToWhereTheSurfaceWas) {
  const Camera before = cameraAt(0), after = cameraAt(0.05);
  const Frame frame = render(after, before, SeedPlan::correlated(1, 1, 2));
  for (int y = 2; y < kH; y += 7) {
    for (int x = 2; x < kW; x += 7) {
      // The camera went right, so the surface was further right, by focal length * 0.05 / z.
      const float expected = 0.05f / (after.pixel * frame.g.z.at(x, y));
      EXPECT_NEAR(frame.g.motion_x.at(x, y), expected, 1e-3f * expected);
      EXPECT_NEAR(frame.g.motion_y.at(x, y), 0, 1e-3f);
      EXPECT_NEAR(frame.g.z_in_prev.at(x, y), frame.g.z.at(x, y), 1e-5f);
    }
  }
}

TEST_F(Fixture, WhereNothingIsHitStandsOneFarSurface) {
  const Camera away({{0, 0, 9}, {}}, pinhole(80, kW, kH)), before({{0, 0, 8}, {}}, pinhole(80, kW, kH));
  const Frame frame = render(away, before, SeedPlan::correlated(1, 1, 2));
  const GBuffer& g = frame.g;
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) {
      ASSERT_EQ((Vec3{g.nx.at(x, y), g.ny.at(x, y), g.nz.at(x, y)}), (Vec3{0, 0, 1}));
      ASSERT_EQ(g.z.at(x, y), kMissDepth);
      ASSERT_EQ(g.z_in_prev.at(x, y), kMissDepth);
      ASSERT_EQ(frame.samples.I1.at(x, y) + frame.samples.I2.at(x, y) + g.albedo.at(x, y), 0);
    }
  }
}

TEST_F(Fixture, AStandingCameraHasNoMotionAtAll) {
  const Frame frame = render(cameraAt(0.3), cameraAt(0.3), SeedPlan::correlated(1, 1, 2));
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) ASSERT_EQ(frame.g.motion_x.at(x, y), 0);
  }
}

// Depth slopes against the depths of the neighbours, on the flat walls.
TEST_F(Fixture, SlopeIsTheStepToTheNextPixel) {
  const Camera camera = cameraAt(0);
  const Frame frame = render(camera, camera, SeedPlan::correlated(1, 1, 2));
  const GBuffer& g = frame.g;
  int checked = 0;
  for (int y = 0; y + 1 < kH; ++y) {
    for (int x = 0; x + 1 < kW; ++x) {
      const auto same = [&](int qx, int qy) {
        return g.nx.at(x, y) == g.nx.at(qx, qy) && g.ny.at(x, y) == g.ny.at(qx, qy) &&
               g.nz.at(x, y) == g.nz.at(qx, qy);
      };
      if (!same(x + 1, y) || !same(x, y + 1)) continue;
      const float step =
          std::max(std::abs(g.z.at(x + 1, y) - g.z.at(x, y)), std::abs(g.z.at(x, y + 1) - g.z.at(x, y)));
      EXPECT_NEAR(g.dz.at(x, y), step, 1e-3f * step + 2e-6f);
      ++checked;
    }
  }
  EXPECT_GT(checked, 500);
}

TEST_F(Fixture, ProbesLieOnSurfaces) {
  const auto points = probePoints(*scene, home, Lens(pinhole(80, 64, 48)));
  ASSERT_EQ(points.size(), 64u * 48);
  for (const Vec3d p : points) EXPECT_LE(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}), 1.0001);
}

}  // namespace
}  // namespace saccade
