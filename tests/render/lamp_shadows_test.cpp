// Visibility by shadow rays, on a floor under a lamp that a card covers in part.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "render/renderer.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

constexpr int kWidth = 64, kHeight = 4;

// A lamp at height 2, and a card at height 1 that ends at x = 0. On the floor the light
// rises from x = -0.2 to x = 0.2.
Scene cardUnderALamp() {
  Scene s = test::floorFromAbove(0.5f);
  s.meshes.push_back(test::quad({-0.2f, -0.5f, 2}, {0, 1, 0}, {0.4f, 0, 0}, 0, {5, 5, 5}));
  s.meshes.push_back(test::quad({-4, -60, 1}, {4, 0, 0}, {0, 120, 0}, 0));
  s.fov_x_deg = 14;
  s.T_world_camera.position = {0, 0, 0.9};
  return s;
}

// Frames of cameras at these x, with shadows wanted everywhere. The last one's are returned.
std::vector<SurfaceShadow> trace(const Scene& scene, const std::vector<double>& xs, int spp = 2,
                                 int threads = 2, float wanted = 0.02f) {
  const PosedScene posed(std::make_shared<RenderScene>(scene));
  TilePool pool(threads);
  Renderer renderer({0, 1});
  FrameRing frames(kWidth, kHeight, 1);
  double before = xs[0];
  for (const double x : xs) {
    const auto cameraAt = [&](double at) {
      Pose pose = scene.T_world_camera;
      pose.position.x = at;
      return Camera(pose, pinhole(scene.fov_x_deg, kWidth, kHeight));
    };
    const Camera camera = cameraAt(x), last = cameraAt(before);
    frames.swap();
    const PixelContext view({posed, camera}, {posed, last});
    renderer.renderSurfaces(view, pool, frames.current());
    for (SurfaceShadow& s : frames.current().surfaces->shadows()) s.wanted = wanted;
    if (&x != &xs[0]) renderer.traceShadows(view, spp, frames.current(), frames.pair().prev, pool);
    before = x;
  }
  return frames.current().surfaces->shadows();
}

double xOf(std::size_t pixel) {
  const double half = 0.9 * std::tan(7 * std::numbers::pi / 180);
  return ((static_cast<double>(pixel % kWidth) + 0.5) / kWidth * 2 - 1) * half;
}

TEST(LampShadows, ALampsEdgeIsLitByTheShareThatIsSeen) {
  const auto shadows = trace(cardUnderALamp(), {0, 0}, 20);
  double squares = 0, penumbra = 0;
  for (std::size_t i = 0; i < shadows.size(); ++i) {
    // Seen from a point at x, the card's end lies at -x on the lamp.
    const double seen = std::clamp((0.2 + xOf(i)) / 0.4, 0., 1.);
    squares += (shadows[i].now.mean - seen) * (shadows[i].now.mean - seen);
    penumbra += shadows[i].now.variance > 0;
    if (seen == 0 || seen == 1) {
      EXPECT_EQ(shadows[i].now.mean, seen) << xOf(i);
    }
  }
  EXPECT_GT(penumbra, kWidth);
  EXPECT_LT(std::sqrt(squares / static_cast<double>(shadows.size())), 0.06);
}

TEST(LampShadows, AStandingCameraChangesNothing) {
  for (const SurfaceShadow& s : trace(cardUnderALamp(), {0, 0.01, 0.01}))
    EXPECT_EQ(s.now.mean, s.before.mean);
}

// A moving shadow changes what lies in it by as much as it moves, and all else by nothing.
TEST(LampShadows, AChangeIsThatOfTheShadow) {
  const double step = 0.02;
  const auto shadows = trace(cardUnderALamp(), {0, step}, 20);
  double sum = 0, inside = 0;
  for (std::size_t i = 0; i < shadows.size(); ++i) {
    const double before = xOf(i), now = before + step;
    if (std::abs(before) < 0.07) sum += shadows[i].now.mean - shadows[i].before.mean, ++inside;
    if (before > 0.21) {
      EXPECT_EQ(shadows[i].now.mean, shadows[i].before.mean) << now;
    }
  }
  ASSERT_GT(inside, 0);
  EXPECT_NEAR(sum / inside, step / 0.4, 0.01);
}

// From full shadow to full light: no ray of a point differs from its others.
TEST(LampShadows, AChangeOfAllRaysHasNoNoise) {
  for (const SurfaceShadow& s : trace(cardUnderALamp(), {-0.4, 0.4})) {
    EXPECT_EQ(s.now.mean - s.before.mean, 1);
    EXPECT_EQ(s.step_variance, 0);
  }
}

// A strong lamp behind a wall takes no rays from the weak one.
TEST(LampShadows, AHiddenLampHarmsNothing) {
  Scene s = cardUnderALamp();
  s.meshes.push_back(test::quad({-20, -20, 9}, {0, 40, 0}, {40, 0, 0}, 0, {1e4f, 1e4f, 1e4f}));
  s.meshes.push_back(test::quad({-60, -60, 8}, {0, 120, 0}, {120, 0, 0}, 0));
  const auto alone = trace(cardUnderALamp(), {0, 0}), both = trace(s, {0, 0});
  const AnalyticLight weak(cardUnderALamp()), all(s);
  for (std::size_t i = 0; i < alone.size(); ++i) {
    const LitPoint p{{static_cast<float>(xOf(i)), 0, 0}, {0, 0, 1}, {0, 0, 1}};
    const EmitterStrengths of_weak(cardUnderALamp()), of_all(s);
    const double share = luminance(weak.at(p, of_weak)) / luminance(all.at(p, of_all));
    EXPECT_NEAR(both[i].now.mean, alone[i].now.mean * share, 0.15 * share) << i;  // a ray or two of twelve
  }
}

// Where a body may have moved, half of the rays tell whether any others are needed.
TEST(LampShadows, PointsWhoseRaysAgreeGetFew) {
  int agree = 0, differ = 0;
  for (const SurfaceShadow& s : trace(cardUnderALamp(), {0.2, 0.21}, 2, 2, SurfaceShadow::kMoves)) {
    const bool one = s.now.mean == s.before.mean && (s.now.mean == 0 || s.now.mean == 1);
    EXPECT_TRUE(s.rays == 32 || (one && (s.rays == 2 || s.rays == 16))) << s.rays << ' ' << s.now.mean;
    agree += s.rays == 16, differ += s.rays == 32;
  }
  EXPECT_GT(agree, 2);
  EXPECT_GT(differ, kWidth);
}

TEST(LampShadows, AreTheSameForAnyNumberOfThreads) {
  const auto one = trace(cardUnderALamp(), {0, 0.01}, 2, 1), five = trace(cardUnderALamp(), {0, 0.01}, 2, 5);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].now.mean, five[i].now.mean);
    EXPECT_EQ(one[i].before.mean, five[i].before.mean);
  }
}

}  // namespace
}  // namespace saccade
