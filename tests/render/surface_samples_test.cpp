// The light of a pixel in parts, against the light of the same pixel as a whole.
#include <gtest/gtest.h>

#include <functional>

#include "cache/bounce_grid.h"
#include "render/renderer.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

constexpr int kSize = 24;

Rgb grey(float v) {
  return {v, v, v};
}

// A floor under a lamp, with a box that casts a shadow; walls give indirect light. The floor is of
// `material`.
Scene lampRoom(const Material& material) {
  Scene s;
  s.materials = {material, test::grey(0.6f)};
  s.meshes = {test::quad({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, 0),
              test::quad({-2, -2, 0}, {0, 4, 0}, {0, 0, 4}, 1),
              test::quad({-2, 2, 0}, {4, 0, 0}, {0, 0, 4}, 1),
              test::quad({1, -0.3f, 3.5f}, {0, 0.6f, 0}, {0.6f, 0, 0}, 1, grey(20)),
              test::quad({-0.5f, 0, 1}, {0.7f, 0, 0}, {0, 0.7f, 0}, 1)};
  s.T_world_camera = {{0, 0, 3}, {1, 0, 0, 0}};  // half a turn about x: looks down
  s.fov_x_deg = 60;
  return s;
}

Frame render(const Scene& scene, int spp, int channels = 1, std::uint64_t seed = 1,
             const BounceGrid* bounces = nullptr) {
  const auto s = std::make_shared<RenderScene>(scene);
  TilePool pool(2);
  Frame frame(kSize, kSize, true);
  frame.surfaces->bounces = bounces;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) frame.surfaces->paths.at(x, y) = static_cast<std::uint32_t>(spp);
  const Camera camera(s->description().T_world_camera, s->description().fov_x_deg, kSize, kSize);
  Renderer renderer(s, {2, channels});
  renderer.renderSurfaces(camera, camera, pool, frame);
  renderer.renderPaths(camera, SeedPlan::independent(seed, 0, spp), pool, frame);
  return frame;
}

// Means over the picture of a function of (x, y).
double mean(const std::function<double(int, int)>& f) {
  double sum = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) sum += f(x, y);
  return sum / (kSize * kSize);
}

Material plastic(BsdfKind kind) {
  Material m = test::grey(0.5f);
  m.reflectance.color0 = {0.7f, 0.4f, 0.1f};
  m.model.kind = kind, m.model.alpha = 0.3f;
  return m;
}

struct Case {
  const char* name;
  Material material;
};
class SurfaceSamplesOf : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(, SurfaceSamplesOf,
                         testing::Values(Case{"diffuse", test::grey(0.5f)},
                                         Case{"plastic", plastic(BsdfKind::kPlastic)},
                                         Case{"roughplastic", plastic(BsdfKind::kRoughPlastic)}),
                         [](const auto& info) { return info.param.name; });

// The closed form is the mean of its samples, and the parts add up to the whole.
TEST_P(SurfaceSamplesOf, PartsAddUp) {
  const Frame frame = render(lampRoom(GetParam().material), 256, 3);
  const SurfaceSamples& on = *frame.surfaces;
  const double U = mean([&](int x, int y) { return on.unoccluded.at(x, y); });
  EXPECT_GT(U, 0.1);
  EXPECT_NEAR(mean([&](int x, int y) { return on.unoccluded_sample.at(x, y); }), U, 0.01 * U);
  const double whole = mean([&](int x, int y) {
    return (frame.samples.I2.at(x, y) - frame.g.emission.at(x, y)) / frame.g.albedo.at(x, y);
  });
  const double parts = mean([&](int x, int y) {
    return on.unoccluded.at(x, y) * on.visible_sample.at(x, y) / on.unoccluded_sample.at(x, y) +
           on.rest.at(x, y);
  });
  EXPECT_NEAR(parts, whole, 0.01 * whole);
}

TEST(SurfaceSamples, TellWhereShadowsAre) {
  const Frame frame = render(lampRoom(test::grey(0.5f)), 16);
  const SurfaceSamples& on = *frame.surfaces;
  EXPECT_EQ(on.kind.at(1, 1), SurfaceKind::kDiffuse);
  EXPECT_EQ(on.visible_sample.at(1, 1), on.unoccluded_sample.at(1, 1));  // far from the box
  int shadowed = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) shadowed += on.visible_sample.at(x, y) == 0;
  EXPECT_GT(shadowed, 5);
  EXPECT_NEAR(on.z.at(1, 1), 0, 1e-5);
  EXPECT_LT(on.x.at(1, 12), on.x.at(20, 12));
}

// Light that is known ends paths, and does not change what they find: no bounce is lost or counted twice.
TEST(SurfaceSamples, EndedPathsFindTheSameLight) {
  Scene scene = lampRoom(test::grey(0.5f));
  scene.fov_x_deg = 12;  // cells are small
  BounceGrid known(10000);
  double all = 0, ended = 0;
  int kept = 0, kept_at_first = 0;
  constexpr std::uint64_t kFrames = 48, kLearning = 16;
  for (std::uint64_t seed = 0; seed < kFrames; ++seed) {
    const auto rest = [&](const BounceGrid* bounces) {
      const Frame frame = render(scene, 16, 3, seed, bounces);
      if (bounces) known.add(frame.surfaces->bounce);
      kept = 0;
      for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) kept += frame.surfaces->bounce.at(x, y).cell != 0;
      return mean([&](int x, int y) { return frame.surfaces->rest.at(x, y); });
    };
    const double without = rest(nullptr), with = rest(&known);
    if (seed >= kLearning) all += without, ended += with;
    if (seed == 0) kept_at_first = kept;
  }
  EXPECT_LT(kept, kept_at_first / 2);
  EXPECT_NEAR(ended, all, 0.01 * all);
}

// Without shadows and without other surfaces nothing is left over.
TEST(SurfaceSamples, AllOfDirectLightIsInClosedForm) {
  Scene s = lampRoom(test::grey(0.5f));
  s.meshes.erase(s.meshes.begin() + 4);                        // the box
  s.meshes.erase(s.meshes.begin() + 1, s.meshes.begin() + 3);  // the walls
  s.materials[1] = test::grey(0);                              // of the lamp
  const Frame frame = render(s, 4);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) ASSERT_NEAR(frame.surfaces->rest.at(x, y), 0, 1e-5);
}

TEST(SurfaceSamples, MetalSharesNoLight) {
  Material metal = test::grey(0.5f);
  metal.model.kind = BsdfKind::kRoughConductor;
  EXPECT_EQ(render(lampRoom(metal), 1).surfaces->kind.at(1, 1), SurfaceKind::kNone);
}

TEST(SurfaceSamples, WhatAMirrorShowsLiesBehindIt) {
  Material mirror = test::grey(0.5f);
  mirror.model.kind = BsdfKind::kConductor;
  Scene s = lampRoom(mirror);
  s.meshes.push_back(test::quad({-2, -2, 3.8f}, {0, 4, 0}, {4, 0, 0}, 1));  // a ceiling
  const Frame frame = render(s, 1);
  EXPECT_EQ(frame.surfaces->kind.at(2, 12), SurfaceKind::kMixed);
  EXPECT_LT(frame.surfaces->z.at(2, 12), -0.1f);
  EXPECT_EQ(frame.surfaces->unoccluded.at(2, 12), 0);
}

}  // namespace
}  // namespace saccade
