// Depth, distance, normals and ids against closed forms of a plane and a sphere.
#include <optional>

#include "render/test_scenes.h"
#include "truth/truth_run.h"

namespace saccade {
namespace {

using test::Pinhole;
using test::Planes;
using test::TruthRun;

constexpr int kW = 40, kH = 30;
constexpr Pinhole kLens{kW, kH, 70};
// 3 above the floor z = 0, looking down at a slant, so that the highest pixels show no floor.
const Pose kCamera{{0.3, -2, 3}, axisAngle({-2.2, 0.1, 0.2})};
const Vec3d kCenter{0.2, 0, 1};
constexpr double kRadius = 0.8;

Scene floorAndBall() {
  Scene s = test::floorFromAbove(0.5f);
  s.materials.push_back(test::grey(0.3f));
  s.spheres.push_back({"ball", toFloat(kCenter), static_cast<float>(kRadius), 1, {}});
  s.meshes.push_back(test::quad({-1, -1, 9}, {0, 2, 0}, {2, 0, 0}, 0, {9, 9, 9}));
  return s;
}

struct Surface {
  double depth;
  Vec3d normal;
  unsigned object, material;
};

// The surface that the ray through (x, y) meets; `edge` is set where that is too near to call.
std::optional<Surface> surfaceAt(int x, int y, bool& edge) {
  const Vec3d d = rotate(kCamera.rotation, kLens.direction(x, y)), to = kCamera.position - kCenter;
  const double b = dot(d, to) / dot(d, d), c = (dot(to, to) - kRadius * kRadius) / dot(d, d);
  const double root = b * b - c;
  edge = std::abs(root) < 1e-3;
  if (root > 0) {
    const double t = -b - std::sqrt(root);
    return Surface{t, (to + d * t) / kRadius, 3, 2};
  }
  const double t = -kCamera.position.z / d.z;
  const Vec3d p = kCamera.position + d * t;
  const double inside = 5 - std::max(std::abs(p.x), std::abs(p.y));
  edge = edge || (t > 0 && std::abs(inside) < 1e-3);
  if (t <= 0 || inside < 0) return std::nullopt;
  return Surface{t, {0, 0, 1}, 1, 1};
}

TEST(TruthSurfaces, ArePlaneAndSphereInClosedForm) {
  TruthRun run(floorAndBall(), Trajectory({{TimeNs(0), kCamera}}), kW, kH, kLens.fov_x_deg);
  const Planes depth = run.first("depth"), distance = run.first("distance"), normals = run.first("normals");
  int floor = 0, ball = 0, none = 0;
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) {
      bool edge = false;
      const auto expected = surfaceAt(x, y, edge);
      if (edge) continue;
      const Vec3d normal{normals.at(0, x, y), normals.at(1, x, y), normals.at(2, x, y)};
      if (!expected) {
        ++none;
        EXPECT_EQ(depth.at(0, x, y), 1e5f);
        EXPECT_EQ(distance.at(0, x, y), 1e5f);
        EXPECT_EQ(normal, Vec3d{});
        continue;
      }
      (expected->object == 3 ? ball : floor) += 1;
      const double rounding = 2e-5 * expected->depth;
      EXPECT_NEAR(depth.at(0, x, y), expected->depth, rounding) << x << " " << y;
      EXPECT_NEAR(distance.at(0, x, y), expected->depth * length(kLens.direction(x, y)), 2 * rounding);
      EXPECT_LT(length(normal - expected->normal), 2e-3) << x << " " << y;
    }
  }
  EXPECT_GT(std::min({floor, ball, none}), 40) << floor << " " << ball << " " << none;
}

TEST(TruthSurfaces, IdsCountMeshesThenSpheresAndMaterials) {
  TruthRun run(floorAndBall(), Trajectory({{TimeNs(0), kCamera}}), kW, kH, kLens.fov_x_deg);
  const auto ids = test::elementsOf<std::uint32_t>(run.source("ids")->sample(run.step()).front());
  ASSERT_EQ(ids.size(), 2u * kW * kH);
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) {
      bool edge = false;
      const auto expected = surfaceAt(x, y, edge);
      if (edge) continue;
      const std::size_t pixel = static_cast<std::size_t>(y) * kW + x;
      EXPECT_EQ(ids[pixel], expected ? expected->object : 0) << x << " " << y;
      EXPECT_EQ(ids[kW * kH + pixel], expected ? expected->material : 0) << x << " " << y;
    }
  }
}

TEST(TruthSurfaces, BrightnessIsTheLogarithmOfTheSensorsIntensity) {
  TruthRun run(floorAndBall(), Trajectory({{TimeNs(0), kCamera}}), kW, kH, kLens.fov_x_deg);
  const FeedInterval interval = run.step();
  TruthConfig config{.name = "", .frames = FrameSelection(), .width = kW, .height = kH};
  config.bias = 0.25;
  const Planes intensity = run.planesOf(findTruth("intensity")->make(config)->sample(interval).back());
  const Planes brightness = run.planesOf(findTruth("brightness")->make(config)->sample(interval).back());
  float most = 0;
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) {
      const float light = interval.change.I_now.at(x, y);
      most = std::max(most, light);
      EXPECT_EQ(intensity.at(0, x, y), light);
      EXPECT_NEAR(brightness.at(0, x, y), std::log(0.25 + light), 1e-6);
    }
  }
  EXPECT_GT(most, 0.01f);
}

}  // namespace
}  // namespace saccade
