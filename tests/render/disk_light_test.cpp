// The light of disks in closed form, against formulas and sums over their area.
#include "render/lights/disk_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/hash_rng.h"
#include "render/bsdf/shading_frame.h"
#include "render/lanes_of_light.h"
#include "render/lights/lamp_points.h"
#include "render/lights/lamps.h"
#include "render/test_scenes.h"
#include "scene/mesh/mesh.h"

namespace saccade {
namespace {

constexpr double kPi = std::numbers::pi;

float u(std::uint32_t i, std::uint32_t dimension) {
  return toUnit(mix32(mix32(dimension + 7) + i));
}

Vec3 direction(std::uint32_t i, std::uint32_t dimension) {
  const float z = 2 * u(i, dimension) - 1, turn = 6.2832f * u(i, dimension + 1), r = std::sqrt(1 - z * z);
  return {r * std::cos(turn), r * std::sin(turn), z};
}

// By rings and sectors, so many of each.
double sumOver(const Disk& disk, const LitPoint& p) {
  constexpr int kRings = 250, kSectors = 500;
  const ShadingFrame<float> frame(disk.normal);
  double sum = 0;
  for (int ring = 0; ring < kRings; ++ring)
    for (int sector = 0; sector < kSectors; ++sector) {
      const double r = disk.radius * (ring + 0.5) / kRings, turn = 2 * kPi * (sector + 0.5) / kSectors;
      const Vec3 to =
          disk.center - p.point + frame.toWorld(toFloat(Vec3d{r * std::cos(turn), r * std::sin(turn), 0}));
      const double arriving = dot(to, p.normal), leaving = -dot(to, disk.normal), d2 = dot(to, to);
      if (arriving > 0 && leaving > 0 && dot(to, p.geometric_normal) > 0)
        sum += r * arriving * leaving / (d2 * d2);
    }
  return sum * 2 * disk.radius / (double{kRings} * kSectors);
}

// Howell's catalog, B-12 and B-13: surfaces on the axis, and beside it at a right angle to the disk.
TEST(DiskLight, IsTheFormFactorOfTheCatalog) {
  const Disk disk{{0, 0, 2}, {0, 0, -1}, 3};
  EXPECT_NEAR(diskFormFactor(disk, {{}, {0, 0, 1}, {0, 0, 1}}), 9. / 13, 1e-6);
  const double h = 2 / 5., r = 3 / 5., z = 1 + h * h + r * r;
  EXPECT_NEAR(diskFormFactor(disk, {{-5, 0, 0}, {1, 0, 0}, {1, 0, 0}}),
              h / 2 * (z / std::sqrt(z * z - 4 * r * r) - 1), 1e-6);
}

// Small, and as good as no distance away.
TEST(DiskLight, LosesNoDigits) {
  const LitPoint p{{}, {0, 0, 1}, {0, 0, 1}};
  const float small = diskFormFactor({{0, 0, 1}, {0, 0, -1}, 1e-4f}, p);
  EXPECT_NEAR(small, 1e-8, 1e-14);
  EXPECT_NEAR(diskFormFactor({{0, 0, 1e-3f}, {0, 0, -1}, 1}, p), 1, 2e-6);
  EXPECT_NEAR(diskFormFactor({{2, 0, 1e-3f}, {0, 0, -1}, 1}, p), 1e-6 / 9, 1e-9);
}

TEST(DiskLight, IsTheSumOverItsArea) {
  int cut = 0, whole = 0;
  for (std::uint32_t i = 0; i < 40; ++i) {
    const Vec3 normal = direction(i, 2), center = direction(i, 4);
    const Disk disk{center, dot(normal, center) < 0 ? normal : -normal, 0.2f + 0.7f * u(i, 6)};
    const Vec3 n = direction(i, 8);
    const LitPoint p{{}, n, i % 2 == 0 ? n : normalize(n + direction(i, 10) * 0.4f)};
    const double sum = sumOver(disk, p);
    EXPECT_NEAR(diskFormFactor(disk, p), sum, 1e-3 * sum + 2e-4) << i;
    const float reach = reachOf<float>(disk, n);
    (dot(center, n) > reach ? whole : cut) += sum > 0;
  }
  EXPECT_GT(cut, 10);
  EXPECT_GT(whole, 4);
}

// Both sides of a horizon through the centre see one half.
TEST(DiskLight, IsNothingBelowTheHorizonAndBehind) {
  const Vec3 up{0, 0, 1};
  EXPECT_EQ(diskFormFactor({{0, 0, -2}, up, 1}, {{}, up, up}), 0);
  EXPECT_EQ(diskFormFactor({{0, 0, 2}, up, 1}, {{}, up, up}), 0);
  EXPECT_EQ(diskFormFactor({{0.2f, 0, 0}, up, 1}, {{}, up, up}), 0);
  const Disk wall{{1, 0, 0}, {-1, 0, 0}, 1};
  const float upper = diskFormFactor(wall, {{}, up, up}), lower = diskFormFactor(wall, {{}, -up, -up});
  EXPECT_GT(upper, 0.09f);
  EXPECT_NEAR(upper, lower, 1e-6);
}

// A floor below a disk of radius 0.5 in the plane z = 1.
class DiskLamp : public testing::Test {
 protected:
  DiskLamp() {
    scene.materials = {test::grey(0.5f)};
    Mesh disk = makeDisk();
    for (Vec3& p : disk.positions) p = Vec3{p.x, -p.y, 0} * 0.5f + Vec3{0.3f, 0.1f, 1};
    disk.radiance = {1, 1, 1};
    scene.meshes = {disk};
  }
  Scene scene;
  const LitPoint floor{{0.2f, 0.1f, 0}, {0, 0, 1}, {0, 0, 1}};
};

TEST_F(DiskLamp, IsFoundInItsMesh) {
  const auto disk = diskOf(scene.meshes[0]);
  ASSERT_TRUE(disk);
  EXPECT_NEAR(length(disk->center - Vec3{0.3f, 0.1f, 1}), 0, 1e-6);
  EXPECT_NEAR(disk->normal.z, -1, 1e-6);
  EXPECT_NEAR(disk->radius, 0.5, 1e-4);
  Mesh ellipse = scene.meshes[0], open = ellipse;
  for (Vec3& p : ellipse.positions) p.x *= 1.01f;
  open.triangles.pop_back();
  EXPECT_FALSE(diskOf(ellipse));
  EXPECT_FALSE(diskOf(open));
}

// Without a vertex in the middle, as a polygon of Blender.
TEST(DiskOf, FindsARegularPolygonInAnyTriangles) {
  Mesh mesh;
  for (int i = 0; i < 32; ++i) {
    const double turn = 2 * kPi * i / 32;
    mesh.positions.push_back(toFloat(Vec3d{5 + std::cos(turn), 2, 3 - std::sin(turn)}));
  }
  for (std::uint32_t i = 1; i + 1 < 32; ++i) mesh.triangles.push_back({0, i, i + 1});
  const auto disk = diskOf(mesh);
  ASSERT_TRUE(disk);
  EXPECT_NEAR(length(disk->center - Vec3{5, 2, 3}), 0, 1e-5);
  EXPECT_NEAR(disk->normal.y, 1, 1e-6);
  EXPECT_NEAR(disk->radius * disk->radius * kPi, 16 * std::sin(kPi / 16), 1e-4);
  Mesh uneven = mesh, bent = mesh, turned = mesh, few = mesh;
  uneven.positions[3] = uneven.positions[2] * 0.5f + uneven.positions[3] * 0.5f;
  bent.positions[3].y += 0.1f;
  std::swap(turned.triangles[7][1], turned.triangles[7][2]);
  few.triangles.pop_back();
  for (const Mesh& other : {uneven, bent, turned, few}) EXPECT_FALSE(diskOf(other));
}

// Its polygon covers the same share, but for the edge.
TEST_F(DiskLamp, GivesTheLightOfItsMesh) {
  const AnalyticLight light(scene);
  EXPECT_TRUE(light.holds(0u));
  double sum = 0;
  for (const auto& [a, b, c] : scene.meshes[0].triangles) {
    AnalyticLight::Side part{};
    for (const std::uint32_t i : {a, b, c}) part.corners.push_back(scene.meshes[0].positions[i]);
    part.normal = {0, 0, -1};
    sum += AnalyticLight::formFactor(part, floor);
  }
  EXPECT_NEAR(luminance(light.at(floor, EmitterStrengths(scene))), sum, 1e-5);
}

TEST_F(DiskLamp, IsTheSameForManyPoints) {
  test::expectTheSameInLanes(
      scene, [](float i) { return std::cos(i); }, 0.02f, 5);
}

// Also where a wall sees the disk in part.
TEST_F(DiskLamp, ItsPointsWeighOneInTheMean) {
  const AnalyticLight light(scene);
  const EmitterStrengths strengths(scene);
  const Vec3 tilted = normalize(Vec3{1, 0, 0.2f});
  for (const LitPoint& from : {floor, LitPoint{{0.4f, 0, 0.5f}, tilted, {1, 0, 0}}}) {
    LampPoints lamps(light, strengths);
    lamps.lookFrom(from, {1, 1, 1});
    constexpr std::uint32_t kPoints = 1 << 14;
    double sum = 0;
    for (std::uint32_t i = 0; i < kPoints; ++i) {
      const LampPoints::Point at = lamps.at(0, u(i, 0), u(i, 1), u(i, 2));
      sum += at.weight;
      EXPECT_NEAR(at.position.z, 1, 1e-6);
      EXPECT_LE(length(at.position - Vec3{0.3f, 0.1f, 1}), 0.5f + 1e-6f);
    }
    EXPECT_NEAR(sum / kPoints, 1, 0.03);
  }
}

// One leaf of all triangles: places are uniform by area, and the pdf is that of a look-up.
TEST_F(DiskLamp, IsOneLampToChoose) {
  const Lamps lamps(scene);
  EXPECT_FALSE(lamps.hasTree(LightSet::kAll));
  EXPECT_EQ(lamps.leaves().size(), 1u);
  scene.meshes.push_back(test::quad({-1, -1, 2}, {0, 2, 0}, {1, 0, 0}, 0, {1, 1, 1}));
  const Lamps both(scene);
  ASSERT_TRUE(both.hasTree(LightSet::kAll));
  std::array<int, 8> eighths{};
  int count = 0;
  for (std::uint32_t i = 0; i < 8192; ++i) {
    const ChosenLamp chosen = both.choose(LightSet::kAll, {floor.point, floor.normal}, u(i, 0));
    if (chosen.number >= 256) continue;
    ++eighths[chosen.number / 32], ++count;
    const Vec3 on = both.areaLamps()[chosen.number].at(0.5f, 0.5f).point - floor.point;
    const EmitterPoint point{0, chosen.number, {1, 1, 1}, length(on), normalize(on).z};
    EXPECT_NEAR(both.pdf(LightSet::kAll, point, {floor.point, floor.normal}) * point.cosine / dot(on, on),
                chosen.pdf, 1e-4f * chosen.pdf);
  }
  EXPECT_GT(count, 1000);
  for (const int n : eighths) EXPECT_NEAR(n, count / 8., 5 * std::sqrt(count / 8.));
}

}  // namespace
}  // namespace saccade
