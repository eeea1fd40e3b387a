// The light of a pixel in parts, against the light of the same pixel as a whole.
#include <gtest/gtest.h>

#include <functional>

#include "cache/grid/bounce_grid.h"
#include "render/primary/sub_pixel.h"
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
             const BounceGrid* bounces = nullptr, int points = 1) {
  const PosedScene posed(std::make_shared<RenderScene>(scene));
  TilePool pool(2);
  Frame frame(kSize, kSize, points);
  const Camera camera(scene.T_world_camera, pinhole(scene.fov_x_deg, kSize, kSize));
  const PixelContext view({posed, camera});
  Renderer renderer({2, channels});
  const SurfaceFrame next = renderer.renderSurfaces(view, pool, frame);
  for (int y = 0; y < kSize; ++y)
    for (SurfacePoint& p : frame.surfaces->row(y)) p.paths = static_cast<std::uint32_t>(spp);
  renderer.renderPaths(view.now, SeedPlan::independent(seed, 0, spp), next, bounces, pool);
  return frame;
}

const SurfacePlace& placeAt(const Frame& frame, int x, int y) {
  return frame.surfaces->place(frame.surfaces->indexOf(x, y));
}
const SurfaceLight& lightAt(const Frame& frame, int x, int y) {
  return frame.surfaces->light(frame.surfaces->indexOf(x, y));
}

// The points that have a sample of light at a second vertex.
int bounceSamples(const Frame& frame) {
  int count = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) count += lightAt(frame, x, y).bounce.cell != 0;
  return count;
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
  const double U = mean([&](int x, int y) { return placeAt(frame, x, y).unoccluded; });
  EXPECT_GT(U, 0.1);
  EXPECT_NEAR(mean([&](int x, int y) { return lightAt(frame, x, y).unoccluded; }), U, 0.01 * U);
  const double whole = mean([&](int x, int y) {
    return (frame.samples.I2.at(x, y) - frame.g.emission.at(x, y)) / frame.g.albedo.at(x, y);
  });
  const double parts = mean([&](int x, int y) {
    const SurfaceLight& light = lightAt(frame, x, y);
    return placeAt(frame, x, y).unoccluded * light.visible / light.unoccluded + light.residual;
  });
  EXPECT_NEAR(parts, whole, 0.01 * whole);
}

TEST(SurfaceSamples, TellWhereShadowsAre) {
  const Frame frame = render(lampRoom(test::grey(0.5f)), 16);
  EXPECT_EQ(frame.surfaces->at(1, 1).kind, SurfaceKind::kDiffuse);
  EXPECT_EQ(lightAt(frame, 1, 1).visible, lightAt(frame, 1, 1).unoccluded);  // far from the box
  int shadowed = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) shadowed += lightAt(frame, x, y).visible == 0;
  EXPECT_GT(shadowed, 5);
  EXPECT_NEAR(placeAt(frame, 1, 1).position.z, 0, 1e-5);
  EXPECT_LT(placeAt(frame, 1, 12).position.x, placeAt(frame, 20, 12).position.x);
}

// Light that is known ends paths, and does not change what they find: no bounce is lost or counted twice.
TEST(SurfaceSamples, EndedPathsFindTheSameLight) {
  Scene scene = lampRoom(test::grey(0.5f));
  scene.fov_x_deg = 12;  // cells are small
  BounceGrid known(10000);
  double all = 0, ended = 0;
  constexpr std::uint64_t kFrames = 48, kLearning = 16;
  for (std::uint64_t seed = 0; seed < kFrames; ++seed) {
    const auto residual = [&](const BounceGrid* bounces) {
      const Frame frame = render(scene, 16, 3, seed, bounces);
      if (bounces) known.add(*frame.surfaces);
      return mean([&](int x, int y) { return lightAt(frame, x, y).residual; });
    };
    const double without = residual(nullptr), with = residual(&known);
    if (seed >= kLearning) all += without, ended += with;
  }
  const BounceGrid empty(10000);
  const auto goOn = [&](const BounceGrid& grid) {
    return bounceSamples(render(scene, 4, 3, kFrames, &grid));
  };
  EXPECT_LT(goOn(known), goOn(empty) / 2);
  EXPECT_NEAR(ended, all, 0.01 * all);
}

// A path that goes on although light is known takes the known light, which has less noise than its own.
TEST(SurfaceSamples, PathsThatGoOnTakeKnownLight) {
  const Scene scene = lampRoom(test::grey(0.5f));
  BounceGrid seen(10000);
  seen.add(*render(scene, 16, 3, 1, &seen).surfaces);
  const auto residuals = [&](float samples, int& go_on) {
    BounceGrid known(10000);
    EXPECT_TRUE(known.restore(seen.keys(), std::vector<Quad>(seen.cells(), Quad{1, 5, 5, 5} * samples)));
    const Frame frame = render(scene, 4, 3, 2, &known);
    go_on = bounceSamples(frame);
    std::vector<float> all;
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) all.push_back(lightAt(frame, x, y).residual);
    return all;
  };
  int some = 0, few = 0;
  const std::vector<float> with = residuals(100, some), without = residuals(2000, few);
  EXPECT_GT(some, few + 20);
  for (std::size_t i = 0; i < with.size(); ++i) ASSERT_NEAR(with[i], without[i], 1e-5 * without[i]) << i;
}

// Without shadows and without other surfaces nothing is left over.
TEST(SurfaceSamples, AllOfDirectLightIsInClosedForm) {
  Scene s = lampRoom(test::grey(0.5f));
  s.meshes.erase(s.meshes.begin() + 4);                        // the box
  s.meshes.erase(s.meshes.begin() + 1, s.meshes.begin() + 3);  // the walls
  s.materials[1] = test::grey(0);                              // of the lamp
  const Frame frame = render(s, 4);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) ASSERT_NEAR(lightAt(frame, x, y).residual, 0, 1e-5);
}

TEST(SurfaceSamples, MetalSharesNoLight) {
  Material metal = test::grey(0.5f);
  metal.model.kind = BsdfKind::kRoughConductor;
  EXPECT_EQ(render(lampRoom(metal), 1).surfaces->at(1, 1).kind, SurfaceKind::kNone);
}

// A black surface reflects nothing: it has no point, and no other method need estimate its light.
TEST(SurfaceSamples, ABlackSurfaceHasNoPoint) {
  const Frame frame = render(lampRoom(test::grey(0)), 1);
  EXPECT_EQ(frame.surfaces->at(1, 1).share, 0);
  EXPECT_FALSE(frame.surfaces->hasUncacheable(1, 1));
  EXPECT_EQ(frame.samples.I2.at(1, 1), 0);
}

TEST(SurfaceSamples, WhatAMirrorShowsLiesBehindIt) {
  Material mirror = test::grey(0.5f);
  mirror.model.kind = BsdfKind::kConductor;
  Scene s = lampRoom(mirror);
  s.meshes.push_back(test::quad({-2, -2, 3.8f}, {0, 4, 0}, {4, 0, 0}, 1));  // a ceiling
  const Frame frame = render(s, 1);
  EXPECT_EQ(frame.surfaces->at(2, 12).kind, SurfaceKind::kMixed);
  EXPECT_LT(placeAt(frame, 2, 12).position.z, -0.1f);
  EXPECT_EQ(placeAt(frame, 2, 12).unoccluded, 0);
}

// With jitter a pixel has a point for each surface that it shows.
TEST(SurfaceSamples, APixelOnOneSurfaceHasOnePoint) {
  const Scene scene = lampRoom(test::grey(0.5f));
  const Frame centres = render(scene, 1), frame = render(scene, 1, 1, 1, nullptr, kSubPixels);
  const SurfacePlace& centre = placeAt(centres, 3, 3);
  const SurfacePlace& point = placeAt(frame, 3 * static_cast<int>(kSubPixels), 3);
  EXPECT_FLOAT_EQ(frame.surfaces->of(3, 3)[0].share, 1);
  EXPECT_EQ(point.position.x, centre.position.x);
  EXPECT_NEAR(point.unoccluded, centre.unoccluded, 1e-6);  // one by one, and in lanes
  for (std::size_t i = 1; i < kSubPixels; ++i) EXPECT_EQ(frame.surfaces->of(3, 3)[i].share, 0);
}

TEST(SurfaceSamples, APixelOnAnEdgeHasAPointForEachSurface) {
  const Frame frame = render(lampRoom(test::grey(0.5f)), 1, 1, 1, nullptr, kSubPixels);
  int edges = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      float shares = 0, least = 10, most = -10;
      for (int column = x * frame.surfaces->perPixel(); column < (x + 1) * frame.surfaces->perPixel();
           ++column) {
        const float share = frame.surfaces->at(column, y).share, z = placeAt(frame, column, y).position.z;
        shares += share;
        if (share > 0) least = std::min(least, z), most = std::max(most, z);
      }
      ASSERT_NEAR(shares, 1, 1e-5);
      edges += least < 0.01f && most > 0.99f;  // floor and box
    }
  }
  EXPECT_GT(edges, 3);
}

// Another method estimates the whole of a pixel that shows metal, and so needs paths of all its points.
TEST(SurfaceSamples, BakedPointsBesideOthersCanHavePaths) {
  Scene scene = lampRoom(test::grey(0.5f));
  scene.materials.push_back(plastic(BsdfKind::kRoughConductor));
  scene.meshes[4].material = 2;  // the box
  const PosedScene posed(std::make_shared<RenderScene>(scene));
  const Camera camera(scene.T_world_camera, pinhole(scene.fov_x_deg, kSize, kSize));
  const PixelContext view({posed, camera});
  TilePool pool(2);
  const auto renderWith = [&](bool baked) {
    Frame frame(kSize, kSize, kSubPixels);
    Renderer renderer({2, 1, true});
    const SurfaceFrame next = renderer.renderSurfaces(view, pool, frame, [&](Tile tile) {
      for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x)
          for (SurfacePoint& p : frame.surfaces->of(x, y)) p.baked = baked && p.kind != SurfaceKind::kNone;
    });
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x)
        for (SurfacePoint& p : frame.surfaces->of(x, y)) p.paths = frame.surfaces->hasUncacheable(x, y);
    renderer.renderPaths(view.now, SeedPlan::independent(1, 0, 1), next, nullptr, pool);
    return frame;
  };
  const Frame expected = renderWith(false), found = renderWith(true);
  int edges = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      ASSERT_EQ(found.samples.I2.at(x, y), expected.samples.I2.at(x, y));
      edges += found.surfaces->hasUncacheable(x, y) &&
               std::ranges::any_of(found.surfaces->of(x, y), &SurfacePoint::baked);
    }
  }
  EXPECT_GT(edges, 3);
}

// Of frames in turn that show the lamp, too.
TEST(SurfaceSamples, NeedPathsUnlessAllPointsAreBaked) {
  const PosedScene posed(std::make_shared<RenderScene>(lampRoom(test::grey(0.5f))));
  const Camera camera({{0, 0, 0.5f}, {0, 0, 0, 1}}, pinhole(70, kSize, kSize));  // looks up
  const PixelContext view({posed, camera});
  TilePool pool(2);
  Frame frame(kSize, kSize, 1);
  Renderer renderer({2, 1});
  for (const int learned : {kSize * kSize, 7, kSize * kSize}) {
    const SurfaceFrame next = renderer.renderSurfaces(view, pool, frame, [&](Tile tile) {
      for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x) frame.surfaces->at(x, y).baked = y * kSize + x < learned;
    });
    EXPECT_EQ(frame.surfaces->needPaths(), learned < kSize * kSize);
    renderer.renderPaths(view.now, SeedPlan::independent(1, 0, 1), next, nullptr, pool);
    double light = 0;
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        ASSERT_EQ(frame.samples.I2.at(x, y), frame.g.emission.at(x, y));
        light += frame.samples.I2.at(x, y);
      }
    EXPECT_GT(light, 0);
  }
}

// The points of a pixel show the light of all of it, as a picture of 16 times the resolution does.
TEST(SurfaceSamples, PointsShowTheLightOfTheWholePixel) {
  constexpr int kFine = 16, kFineSize = kFine * kSize;
  const Scene scene = lampRoom(test::grey(0.05f));
  const PosedScene posed(std::make_shared<RenderScene>(scene));
  const Camera camera(scene.T_world_camera, pinhole(scene.fov_x_deg, kFineSize, kFineSize));
  TilePool pool(2);
  Frame fine(kFineSize, kFineSize);
  Renderer({2, 1}).render(PixelContext({posed, camera}), SeedPlan::independent(7, 0, 8), pool, fine);
  const auto error = [&](int points) {
    const Frame frame = render(scene, 512, 1, 3, nullptr, points);
    return mean([&](int x, int y) {
      double whole = 0;
      for (int i = 0; i < kFine * kFine; ++i)
        whole += fine.samples.I2.at(kFine * x + i % kFine, kFine * y + i / kFine) / (kFine * kFine);
      return std::abs(frame.samples.I2.at(x, y) - whole);
    });
  };
  EXPECT_LT(error(kSubPixels), 0.5 * error(1));
}

}  // namespace
}  // namespace saccade
