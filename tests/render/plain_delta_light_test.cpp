#include "render/tiles/plain_delta_light.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/test_scenes.h"

namespace saccade {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kLeft = -0.41f, kRight = 0.23f;  // of a screen at z = 1

// A floor below a screen of some opacity. A point, a spot and a sun shine from above, and a sun from below.
Scene floorBelowScreen(float opacity) {
  Scene s = test::floorFromAbove(0.5f);
  s.materials.push_back(test::grey(0));
  s.materials[1].opacity.color0 = {opacity, opacity, opacity};
  s.meshes.push_back(test::quad({kLeft, -5, 1}, {kRight - kLeft, 0, 0}, {0, 10, 0}, 1));
  s.point_lights = {{{0.1f, 0.2f, 3}, {4, 5, 6}}};
  s.spot_lights = {{{0.6f, 0, 2.5f}, {0, 0, -1}, {9, 8, 7}, 0.2f, 0.7f}};
  s.directional_lights = {{{0.6f, 0, -0.8f}, {1, 2, 3}}, {{0, 0, 1}, {50, 50, 50}}};
  return s;
}

// Points of the floor in all lanes, with normals and colours of their own.
PlainSurfaces surfaces() {
  PlainSurfaces s{};
  for (int i = 0; i < kLaneVectors; ++i) {
    const auto f = static_cast<float>(i);
    s.point.set(i, {0.2f * f - 1.5f, 0.05f * f, 0});
    s.geometric_normal.set(i, {0, 0, 1}), s.shading_normal.set(i, normalize(Vec3{0.02f * f, 0, 1}));
    s.reflectance.set(i, {0.05f * f, 0.4f, 0.8f - 0.05f * f}), s.offset[i] = 1e-5f;
  }
  return s;
}

struct Incident {
  Vec3 w;        // unit, to the lamp
  Rgb radiance;  // at a right angle
};
// Of the lamps above the floor, by their laws.
std::vector<Incident> incident(const Scene& scene, Vec3 p) {
  const auto to = [&](Vec3 lamp) { return lamp - p; };
  const Vec3 point = to(scene.point_lights[0].position), spot = to(scene.spot_lights[0].position);
  const SpotLight& cone = scene.spot_lights[0];
  const float angle = std::acos(spot.z / length(spot));
  const float falloff = std::clamp((cone.cutoff - angle) / (cone.cutoff - cone.beam), 0.f, 1.f);
  return {{normalize(point), scene.point_lights[0].intensity / dot(point, point)},
          {normalize(spot), cone.intensity * (falloff / dot(spot, spot))},
          {{-0.6f, 0, 0.8f}, scene.directional_lights[0].irradiance}};
}

float expected(const Scene& scene, const PlainSurfaces& s, int lane, float through) {
  const Vec3 p = s.point.at(lane);
  float sum = 0;
  for (const auto& [w, radiance] : incident(scene, p)) {
    const float at_screen = p.x + w.x / w.z;
    const float arrives = at_screen > kLeft && at_screen < kRight ? through : 1;
    const float cosine = std::max(0.f, dot(w, s.shading_normal.at(lane)));
    sum += arrives * cosine / kPi * luminance(s.reflectance.at(lane) * radiance);
  }
  return sum;
}

// Where a screen lets nothing or a part through, and in those lanes alone that are asked for.
TEST(PlainDeltaLight, IsThatOfEachLampThatAScreenLeaves) {
  const PlainSurfaces s = surfaces();
  const LaneSet asked = LaneSet::first(15);
  for (const float opacity : {1.f, 0.25f}) {
    const Scene scene = floorBelowScreen(opacity);
    const PosedScene posed(std::make_shared<RenderScene>(scene));
    const PlainDeltaLight<kPlastics> light(posed);
    ASSERT_TRUE(light.isOfAll());
    std::array<float, kLaneVectors> found{};
    light.add(s, asked,
              [&](int lane, float luminance) { found[static_cast<std::size_t>(lane)] += luminance; });
    for (int i = 0; i < kLaneVectors; ++i) {
      const float truth = asked.has(i) ? expected(scene, s, i, 1 - opacity) : 0;
      EXPECT_NEAR(found[static_cast<std::size_t>(i)], truth, 2e-5f * truth) << i << ", " << opacity;
    }
  }
}

}  // namespace
}  // namespace saccade
