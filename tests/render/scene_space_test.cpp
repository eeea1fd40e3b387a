#include "render/world/scene_space.h"

#include <gtest/gtest.h>

#include "base/hash_rng.h"
#include "render/test_scenes.h"
#include "render/world/triangle_distance.h"

namespace saccade {
namespace {

double draw(std::uint64_t n, double most) {
  return (2 * static_cast<double>(toUnit(hashKey(7, n))) - 1) * most;
}
Vec3d drawPoint(std::uint64_t n, double most) {
  return {draw(3 * n, most), draw(3 * n + 1, most), draw(3 * n + 2, most)};
}

// By many points of the triangle.
double sampledDistance(Vec3d p, Vec3d a, Vec3d b, Vec3d c) {
  constexpr int kSteps = 60;
  double least = 1e9;
  for (int i = 0; i <= kSteps; ++i)
    for (int k = 0; i + k <= kSteps; ++k) {
      const double u = static_cast<double>(i) / kSteps, v = static_cast<double>(k) / kSteps;
      least = std::min(least, length(a + (b - a) * u + (c - a) * v - p));
    }
  return least;
}

TEST(TriangleDistance, IsThatOfItsNearestPoint) {
  for (std::uint64_t n = 0; n < 300; ++n) {
    const Vec3d a = drawPoint(4 * n, 1), b = drawPoint(4 * n + 1, 1), c = drawPoint(4 * n + 2, 1),
                p = drawPoint(4 * n + 3, 2);
    const double found = triangleDistance(p, a, b, c), sampled = sampledDistance(p, a, b, c);
    EXPECT_LE(found, sampled + 1e-12);
    EXPECT_GE(found, sampled - 0.06);
  }
  EXPECT_NEAR(triangleDistance({0.2, 0.3, -0.4}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 0.4, 1e-15);
}

TEST(TriangleDistance, MayBeOfATriangleWithoutArea) {
  const Vec3d a{1, 0, 0}, b{3, 0, 0}, between{2.1, 0, 0};
  EXPECT_EQ(triangleDistance({1, 3, 4}, a, a, a), 5);
  for (const Vec3d third : {a, b, between}) {
    EXPECT_EQ(triangleDistance({2, 1, 0}, a, b, third), 1);
    EXPECT_EQ(triangleDistance({2, 1, 0}, third, a, b), 1);
    EXPECT_EQ(triangleDistance({2, 1, 0}, b, third, a), 1);
  }
}

// Triangles at random and two balls, far from the origin of the world.
Scene confetti() {
  Scene s;
  s.materials = {test::grey(0.5f)};
  Mesh mesh;
  for (std::uint32_t n = 0; n < 200; ++n) {
    const Vec3d middle = drawPoint(1000 + n, 5);
    for (std::uint64_t k = 0; k < 3; ++k)
      mesh.positions.push_back(toFloat(middle + drawPoint(2000 + 3 * n + k, 0.5)));
    mesh.triangles.push_back({3 * n, 3 * n + 1, 3 * n + 2});
  }
  mesh.positions.push_back({});
  s.meshes = {mesh, test::quad({-9, -9, -9}, {1, 0, 0}, {0, 1, 0}, 0)};
  s.spheres = {{"ball", {1, 1, 1}, 0.5f, 0, {}}, {"lamp", {-6, 0, 0}, 1, 0, {1, 1, 1}}};
  s.origin = {1e5, -2e5, 3e5};
  return s;
}

double bruteDistance(const Scene& s, Vec3d p) {
  double least = 1e9;
  for (const Mesh& mesh : s.meshes)
    for (const auto& [i, k, l] : mesh.triangles) {
      const auto at = [&](std::uint32_t corner) { return toDouble(mesh.positions[corner]); };
      least = std::min(least, triangleDistance(p, at(i), at(k), at(l)));
    }
  for (const Sphere& ball : s.spheres)
    least = std::min(least, std::abs(length(toDouble(ball.center) - p) - static_cast<double>(ball.radius)));
  return least;
}

TEST(SceneSpace, KnowsTheDistanceToTheNearestSurface) {
  const RenderScene scene(confetti());
  const SceneSpace space(scene);
  const Vec3d origin = scene.description().origin;
  for (std::uint64_t n = 0; n < 500; ++n) {
    const Vec3d p = drawPoint(n, 8);
    const double exact = bruteDistance(scene.description(), p);
    EXPECT_NEAR(space.distance(origin + p, 1e9), exact, 1e-5);
    EXPECT_NEAR(space.distance(origin + p, exact + 0.1), exact, 1e-5);
    EXPECT_EQ(space.distance(origin + p, exact / 2), exact / 2);
  }
}

TEST(SceneSpace, IsNearABallFromWithin) {
  const RenderScene scene(confetti());
  const Vec3d origin = scene.description().origin;
  EXPECT_NEAR(SceneSpace(scene).distance(origin + Vec3d{-6.2, 0, 0}, 10), 0.8, 1e-4);
}

TEST(SceneSpace, LooksUntilTheFirstSurface) {
  Scene s;
  s.materials = {test::grey(0.5f)};
  s.meshes = {test::quad({-50, -50, 4}, {100, 0, 0}, {0, 100, 0}, 0)};
  s.origin = {10, 20, 30};
  const RenderScene scene(std::move(s));
  std::vector<Vec3d> directions;
  for (int i = 0; i < 37; ++i)
    directions.push_back(normalize(Vec3d{0.05 * (i - 18), 0.1, i % 3 == 0 ? -1.0 : 1.0}));
  std::vector<double> distances(directions.size());
  SceneSpace(scene).look({10, 20, 32}, directions, distances);
  for (std::size_t i = 0; i < directions.size(); ++i)
    if (directions[i].z < 0)
      EXPECT_TRUE(std::isinf(distances[i]));
    else
      EXPECT_NEAR(distances[i], 2 / directions[i].z, 1e-5);
}

}  // namespace
}  // namespace saccade
