// Frames of cameras with distortion, against the formulas of their lenses.
#include <gtest/gtest.h>

#include <cmath>

#include "render/renderer.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

constexpr int kW = 64, kH = 48;

CameraModel barrel() {
  return {.width = kW,
          .height = kH,
          .fx = 45,
          .fy = 43,
          .cx = 30.2,
          .cy = 24.6,
          .distortion = {LensModel::kRadTan, {-0.22, 0.05, 0.004, -0.003, 0}}};
}

CameraModel fisheye() {
  return {.width = kW,
          .height = kH,
          .fx = 32,
          .fy = 33,
          .cx = 31,
          .cy = 24,
          .distortion = {LensModel::kEquidistant, {-0.03, 0.01, 0, 0, 0}}};
}

struct Shown {
  double x, y;
};

// Where OpenCV's formulas put a point in the axes of the camera.
Shown formula(const CameraModel& c, Vec3d p) {
  const auto& k = c.distortion.k;
  const double a = p.x / p.z, b = p.y / p.z, r = std::hypot(a, b), t = std::atan(r);
  if (c.distortion.model == LensModel::kEquidistant) {
    const double scale = r > 0 ? t * (1 + k[0] * t * t + k[1] * t * t * t * t) / r : 1;
    return {c.fx * scale * a + c.cx, c.fy * scale * b + c.cy};
  }
  const double radial = 1 + k[0] * r * r + k[1] * r * r * r * r;
  return {c.fx * (a * radial + 2 * k[2] * a * b + k[3] * (r * r + 2 * a * a)) + c.cx,
          c.fy * (b * radial + k[2] * (r * r + 2 * b * b) + 2 * k[3] * a * b) + c.cy};
}

Vec3d inAxesOf(const Pose& pose, Vec3 point) {
  const Pose to_camera = inverse(pose);
  return to_camera.position + rotate(to_camera.rotation, toDouble(point));
}

Frame render(const Scene& scene, const Camera& now, const Camera& prev) {
  TilePool pool(1);
  Frame frame(kW, kH);
  const PosedScene posed(std::make_shared<RenderScene>(scene));
  Renderer({0, 1}).render(PixelContext({posed, now}, {posed, prev}), SeedPlan::correlated(1, 1, 2), pool,
                          frame);
  return frame;
}

TEST(LensRender, MotionIsThatOfTheHitPointThroughTheLens) {
  const Scene scene = test::furnace(0.5f, 1);
  const Pose before{{0.1, 0.05, -0.6}, axisAngle({0.02, 0.1, -0.03})};
  const Pose after{{0.14, 0.02, -0.57}, axisAngle({0.05, 0.08, 0})};
  for (const CameraModel& model : {barrel(), fisheye()}) {
    Lens lens(model);
    lens.tabulate();
    const Camera now(after, lens), prev(before, lens);
    const GBuffer g = render(scene, now, prev).g;
    for (int y = 0; y < kH; y += 3) {
      for (int x = 0; x < kW; x += 3) {
        const auto px = static_cast<float>(x), py = static_cast<float>(y);
        const Vec3 hit = now.origin + now.direction(px, py) * g.z.at(x, y);
        const Shown at = formula(model, inAxesOf(after, hit)), was = formula(model, inAxesOf(before, hit));
        ASSERT_NEAR(at.x, x, 1e-3);
        ASSERT_NEAR(at.y, y, 1e-3);
        ASSERT_NEAR(g.motion_x.at(x, y), was.x - x, 1e-3);
        ASSERT_NEAR(g.motion_y.at(x, y), was.y - y, 1e-3);
      }
    }
  }
}

TEST(LensRender, AStandingCameraHasNoMotionAtAll) {
  Lens lens(fisheye());
  lens.tabulate();
  const Camera camera({{0.1, 0.05, -0.6}, axisAngle({0.02, 0.1, -0.03})}, lens);
  const GBuffer g = render(test::furnace(0.5f, 1), camera, camera).g;
  for (int y = 0; y < kH; ++y)
    for (int x = 0; x < kW; ++x) ASSERT_EQ(std::abs(g.motion_x.at(x, y)) + std::abs(g.motion_y.at(x, y)), 0);
}

// A bright half plane whose edge is X = 0.7 at depth 2: in each row, the edge is where the formula says.
TEST(LensRender, AStraightEdgeIsBentAsTheFormulaSays) {
  Scene scene;
  scene.materials = {test::grey(0.5f)};
  scene.meshes = {test::quad({0.7f, -200, 2}, {0, 400, 0}, {200, 0, 0}, 0, {1, 1, 1})};
  for (const CameraModel& model : {barrel(), fisheye()}) {
    Lens lens(model);
    lens.tabulate();
    const GBuffer g = render(scene, Camera(Pose{}, lens), Camera(Pose{}, lens)).g;
    double leftmost = kW, rightmost = 0;
    for (int row = 0; row < kH; ++row) {
      double low = -4, high = 4;  // Y where the edge crosses the row
      for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (formula(model, {0.7, middle, 2}).y < row ? low : high) = middle;
      }
      const double edge = formula(model, {0.7, low, 2}).x;
      leftmost = std::min(leftmost, edge), rightmost = std::max(rightmost, edge);
      ASSERT_EQ(g.emission.at(static_cast<int>(std::floor(edge)), row), 0) << row;
      ASSERT_NEAR(g.emission.at(static_cast<int>(std::ceil(edge)), row), 1, 1e-6) << row;
    }
    EXPECT_GT(rightmost - leftmost, 0.8);  // it is bent
  }
}

TEST(LensRender, SlopeIsTheStepToTheNextPixel) {
  Scene scene;
  scene.materials = {test::grey(0.5f)};
  scene.meshes = {test::quad({-200, -200, 90}, {0, 400, 0}, {400, 0, -150}, 0)};  // leans to the right
  for (const CameraModel& model : {barrel(), fisheye()}) {
    Lens lens(model);
    lens.tabulate();
    const GBuffer g = render(scene, Camera(Pose{}, lens), Camera(Pose{}, lens)).g;
    for (int y = 10; y < kH - 10; y += 5) {
      for (int x = 10; x < kW - 10; x += 5) {
        const float dx = std::abs(g.z.at(x + 1, y) - g.z.at(x - 1, y)) / 2;
        const float dy = std::abs(g.z.at(x, y + 1) - g.z.at(x, y - 1)) / 2;
        EXPECT_NEAR(g.dz.at(x, y), std::max(dx, dy), 0.05f * std::max(dx, dy)) << x << "," << y;
      }
    }
  }
}

// A fisheye shows equal angles in equal pixels. At 60 degrees a pixel is 1 / cos^2 times as deep, and tan(t)
// / t times as wide, as in the middle.
TEST(LensRender, PixelsOfAFisheyeGrowTowardsTheEdge) {
  const Lens lens({.width = kW,
                   .height = kH,
                   .fx = 28,
                   .fy = 28,
                   .cx = 31.5,
                   .cy = 23.5,
                   .distortion = {LensModel::kEquidistant, {}}});
  const Camera camera(Pose{}, lens);
  const float theta = std::acos(0.5f);
  const float expected = std::sqrt(4 * std::tan(theta) / theta);
  EXPECT_NEAR(camera.pixelAt({std::tan(theta), 0, 1}) / camera.pixel, expected, 1e-4f);
  EXPECT_NEAR(camera.pixelAt({0, 0, 1}) / camera.pixel, 1, 1e-6f);
}

TEST(LensRender, AShiftMovesTheGridOfPixels) {
  Lens lens(barrel());
  lens.tabulate();
  const Camera still(Pose{}, lens);
  Camera shifted(Pose{}, lens);
  shifted.shift(0.3f, -0.2f);
  const Vec3 a = still.direction(9.7f, 20.2f), b = shifted.direction(10, 20);
  EXPECT_NEAR(length(a - b), 0, 1e-6f);
  EXPECT_NEAR(shifted.projectDirection(b).x, 10, 1e-3f);
  EXPECT_NEAR(shifted.projectDirection(b).y, 20, 1e-3f);
}

}  // namespace
}  // namespace saccade
