// Rays that leave a surface do not meet it again, and shapes far away do not move them.
#include "render/world/ray_offset.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "render/bsdf/shading_frame.h"
#include "render/test_scenes.h"
#include "render/world/surface_at.h"

namespace saccade {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

class Numbers {
 public:
  float in(float low, float high) { return std::uniform_real_distribution<float>(low, high)(random_); }
  float magnitude(float low, float high) { return std::exp(in(std::log(low), std::log(high))); }
  Vec3 direction() {
    std::normal_distribution<float> normal;
    return normalize(Vec3{normal(random_), normal(random_), normal(random_)});
  }

 private:
  std::mt19937 random_{1};
};

PosedScene open(Scene scene) {
  scene.materials = {test::grey(0.5f)};
  return PosedScene(std::make_shared<RenderScene>(std::move(scene)));
}

Surface surfaceOn(const PosedScene& scene, const Ray& ray) {
  const Hit hit = scene.still().geometry().intersect(ray);
  EXPECT_TRUE(hit.valid);
  return surfaceAt<kPlainDiffuse>(scene, ray, hit, 0);
}

// Whether a ray meets something, alone or in a packet.
bool meets(const PosedScene& scene, const Ray& ray) {
  RayPacket<8> packet;
  packet.set(3, ray);
  LaneSet lane;
  lane.add(3);
  scene.still().geometry().occluded(packet, lane);
  return packet.far[3] < 0 || scene.still().geometry().intersect(ray).valid;
}

// Directions above the surface, most of them grazing.
Vec3 outwards(const Surface& s, Numbers& u) {
  const float z = u.magnitude(1e-5f, 1), r = std::sqrt(1 - z * z), turn = u.in(0, 6.28f);
  return ShadingFrame<float>(s.geometric_normal).toWorld({r * std::cos(turn), r * std::sin(turn), z});
}

constexpr int kRaysEach = 300;

// Of rays to both sides of a surface that others from anywhere have met at targetOn().
int returnsOf(const PosedScene& scene, Numbers& u, const auto& targetOn) {
  int returns = 0;
  for (int i = 0; i < kRaysEach; ++i) {
    const Vec3 target = targetOn(), from = target + u.direction() * u.magnitude(0.01f, 100);
    const Hit hit = scene.still().geometry().intersect({from, target - from, kFar});
    if (!hit.valid) continue;  // off the edge
    const Surface s = surfaceAt<kPlainDiffuse>(scene, {from, target - from, kFar}, hit, 0);
    returns += meets(scene, {leave(s), outwards(s, u), kFar});
    returns += meets(scene, {leave(s, true), -outwards(s, u), kFar});
  }
  return returns;
}

TEST(RayOffset, RaysDoNotMeetTheFlatSurfaceThatTheyLeave) {
  Numbers u;
  for (int i = 0; i < 300; ++i) {
    const float edge = u.magnitude(0.01f, 3000);
    const Vec3 e1 = u.direction() * edge,
               e2 = normalize(cross(e1, u.direction())) * u.magnitude(edge / 100, edge);
    const Vec3 corner = u.direction() * u.magnitude(0.1f, 1000) - e1 * 0.5f;
    Scene scene;
    scene.meshes = {test::quad(corner, e1, e2, 0)};
    const PosedScene posed = open(scene);
    const auto target = [&] { return corner + e1 * u.in(0.001f, 0.999f) + e2 * u.in(0.001f, 0.999f); };
    EXPECT_EQ(returnsOf(posed, u, target), 0) << "edge " << edge << ", " << length(corner) << " from 0";
  }
}

TEST(RayOffset, RaysDoNotMeetTheSphereThatTheyLeave) {
  Numbers u;
  for (int i = 0; i < 100; ++i) {
    const float radius = u.magnitude(0.01f, 100);
    const Vec3 center = u.direction() * (radius * u.magnitude(0.1f, 1000));
    Scene scene;
    scene.spheres = {{"ball", center, radius, 0, {}}};
    const PosedScene posed = open(scene);
    int returns = 0;
    for (int k = 0; k < kRaysEach; ++k) {
      const Vec3 out = u.direction(), from = center + out * (radius * u.magnitude(1.01f, 100));
      const Vec3 along = center + u.direction() * (0.99f * radius) - from;
      const Surface s = surfaceOn(posed, {from, along, kFar});
      returns += meets(posed, {leave(s), outwards(s, u), kFar});
      const Hit far_side = posed.still().geometry().intersect({leave(s, true), -s.geometric_normal, kFar});
      EXPECT_NEAR(far_side.t, 2 * radius, 0.02f * radius);
    }
    EXPECT_EQ(returns, 0) << "radius " << radius << ", " << length(center) << " from 0";
  }
}

// A floor of 2 km under a table's top of 1 m.
TEST(RayOffset, ShapesFarAwayDoNotMoveRays) {
  Scene scene;
  scene.meshes = {test::quad({-0.5f, -0.5f, 1}, {1, 0, 0}, {0, 1, 0}, 0)};
  const Ray down{{0.1f, 0.2f, 2}, {0, 0, -1}, kFar};
  const auto heightAbove = [&] { return leave(surfaceOn(open(scene), down)).z - 1; };
  const float alone = heightAbove();
  EXPECT_GT(alone, 0);
  EXPECT_LT(alone, 1e-5f);
  scene.meshes.push_back(test::quad({-1000, -1000, 0}, {2000, 0, 0}, {0, 2000, 0}, 0));
  EXPECT_EQ(heightAbove(), alone);
}

}  // namespace
}  // namespace saccade
