// Pixels at any times, against whole frames of the same times.
#include "render/tiles/point_sampler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "base/instruction_set.h"
#include "render/renderer.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

constexpr int kW = 31, kH = 23, kMoments = 3;

// Plain, textured and smooth surfaces, plastic, a mirror, a lamp in view, a sun, and a gap that shows
// nothing.
Scene room() {
  Scene s;
  s.materials = {test::grey(0.6f), test::grey(0.5f), test::grey(0.7f, false), test::grey(0.5f),
                 test::grey(0.4f)};
  s.materials[1].reflectance = {.kind = SurfaceColor::Kind::kCheckerboard,
                                .color0 = {0.9f, 0.1f, 0.2f},
                                .color1 = {0.1f, 0.8f, 0.3f},
                                .uv_scale = {4, 4}};
  s.materials[3].model.kind = BsdfKind::kConductor;
  s.materials[4].model.kind = BsdfKind::kPlastic;
  s.meshes = {test::quad({-1, -1, 1}, {0, 2, 0}, {2, 0, 0}, 1),
              test::quad({-1, -1, -1}, {0, 2, 0}, {0, 0, 2}, 0),
              test::quad({1, -1, -1}, {0, 2, 0}, {0, 0, 2}, 2),
              test::quad({-1, 1, -1}, {2, 0, 0}, {0, 0, 1.2f}, 4),
              test::quad({-0.3f, -0.95f, 0.2f}, {0, 0, 0.6f}, {0.6f, 0, 0}, 0, {9, 8, 7}),
              test::quad({0.2f, 0.3f, 0.6f}, {0.3f, 0, 0}, {0, 0.3f, 0}, 3)};
  s.spheres.push_back({"ball", {0.4f, -0.3f, 0.4f}, 0.3f, 0, {}, {}});
  s.directional_lights.push_back({normalize(Vec3{0.2f, 0.4f, 1}), {2, 2, 2}});
  s.T_world_camera = {{0, 0, -0.9}, {}};
  s.fov_x_deg = 75;
  return s;
}

struct PointSamplerTest : testing::Test {
  PointSamplerTest() {
    for (int k = 0; k < kMoments; ++k) cameras.emplace_back(Pose{{0.01 * k, 0, -0.9}, {}}, lens);
  }

  Frame frameAt(int moment) {
    Frame frame(kW, kH, 1);
    const PosedView view{scene, cameras[static_cast<std::size_t>(moment)]};
    Renderer({}).renderSurfaces(PixelContext(view), pool, frame);
    return frame;
  }
  // Each pixel at moments in turn, so that packets mix them.
  static std::vector<PixelMoment> mixed() {
    std::vector<PixelMoment> all;
    for (std::uint16_t y = 0; y < kH; ++y)
      for (std::uint16_t x = 0; x < kW; ++x) all.push_back({x, y, (x + y) % std::uint32_t{kMoments}});
    return all;
  }
  void expectThoseOfFrames() {
    std::vector<Frame> frames;
    for (int k = 0; k < kMoments; ++k) frames.push_back(frameAt(k));
    const std::vector<PixelMoment> all = mixed();
    PointSampler sampler;
    std::vector<PointSample> found(PointSampler::kMost);
    int kinds[3] = {}, black = 0;
    for (std::size_t first = 0; first < all.size(); first += PointSampler::kMost) {
      const auto asked = std::span(all).subspan(first, std::min(PointSampler::kMost, all.size() - first));
      sampler.look({scene, cameras}, asked, found);
      for (std::size_t k = 0; k < asked.size(); ++k) {
        const auto [x, y, moment] = asked[k];
        SCOPED_TRACE(testing::Message() << x << ", " << y << " at " << moment);
        const Frame& frame = frames[moment];
        expectSame(found[k], frame, x, y);
        ++kinds[static_cast<int>(found[k].kind)], black += found[k].albedo <= 0;
      }
    }
    for (const int count : kinds) EXPECT_GT(count, 3);
    EXPECT_GT(black, 10);
  }
  static void expectSame(const PointSample& point, const Frame& frame, int x, int y) {
    const SurfacePoint& there = frame.surfaces->at(x, y);
    ASSERT_EQ(point.kind, there.kind);
    EXPECT_EQ(point.isUncacheable(), there.isUncacheable());
    EXPECT_NEAR(point.emission, frame.g.emission.at(x, y), 1e-4f);
    if (there.share > 0) {
      EXPECT_NEAR(point.albedo, frame.g.albedo.at(x, y), 1e-5f);
    } else {
      EXPECT_EQ(point.albedo, 0);
    }
    if (point.kind == SurfaceKind::kNone) return;
    const SurfacePlace& place = frame.surfaces->place(frame.surfaces->indexOf(x, y));
    EXPECT_LT(length(point.place.position - place.position), 1e-5f);
    EXPECT_LT(length(point.place.normal - place.normal), 1e-5f);
    EXPECT_NEAR(point.place.footprint, place.footprint, 1e-6f);
    EXPECT_NEAR(point.place.unoccluded, place.unoccluded, 1e-4f);
  }

  const PosedScene scene{std::make_shared<RenderScene>(room())};
  Lens lens{pinhole(75, kW, kH)};
  std::vector<Camera> cameras;
  TilePool pool{2};
};

TEST_F(PointSamplerTest, FindsWhatFramesShow) {
  expectThoseOfFrames();
  useInstructionSet("avx2");
  expectThoseOfFrames();
  useInstructionSet(kInstructionSetNames[static_cast<std::size_t>(widestInstructionSet())]);
}

TEST_F(PointSamplerTest, FindsItThroughALens) {
  CameraModel model = pinhole(75, kW, kH);
  model.distortion.k[0] = -0.1;
  lens = Lens(model);
  lens.tabulate();
  cameras.clear();
  for (int k = 0; k < kMoments; ++k) cameras.emplace_back(Pose{{0.01 * k, 0, -0.9}, {}}, lens);
  expectThoseOfFrames();
}

// A card covers a part of a lamp. Moments of the camera are 3/16 of a pixel apart.
struct PointShadows : testing::Test {
  static constexpr float kHalf = 0.1f;
  static constexpr int kPixels = 64;

  static Scene cardUnderALamp() {
    Scene s = test::floorFromAbove(0.5f);
    s.meshes.push_back(test::quad({-kHalf, -kHalf, 2}, {0, 2 * kHalf, 0}, {2 * kHalf, 0, 0}, 0, {9, 9, 9}));
    s.meshes.push_back(test::quad({-4, -60, 1}, {4, 0, 0}, {0, 120, 0}, 0));
    return s;
  }
  PointShadows() {
    const double pixel = 2 * 0.9 * std::tan(13 * std::numbers::pi / 180) / kPixels;
    for (const int k : {0, 1, 2})
      cameras.emplace_back(Pose{{k * pixel * 3 / 16, 0, 0.9}, {1, 0, 0, 0}}, pinhole(26, kPixels, 3));
    const PixelContext view({scene, cameras[0]});
    for (Frame* frame : {&before, &end}) renderer.renderSurfaces(view, pool, *frame);
    for (SurfaceShadow& shadow : end.surfaces->shadows()) shadow.wanted = 0.5f;
    end.surfaces->setWantShadows(true);
    renderer.traceShadows(view, 2, end, before, pool);
  }
  // Looks up the middle row at a moment, with `rays` around it by pixel. Rays cannot tell of pixel 0. Returns
  // how many it traces.
  std::size_t lookAt(std::uint32_t moment, std::vector<RaysAround>& rays) {
    std::vector<PixelMoment> asked;
    for (std::uint16_t x = 0; x < kPixels; ++x) asked.push_back({x, 1, moment});
    const PointView view{scene, cameras};
    sampler.look(view, asked, points);
    std::ranges::fill(light, PlaceLight{.known = true, .visibility = 0.5f, .shadow = 1});
    light[0].shadow = 0;
    const EndShadows ends{*end.surfaces, *before.surfaces, renderer.shadowRays(), 2};
    return sampler.traceShadows(view, {asked, points, rays}, ends, known, light);
  }

  const PosedScene scene{std::make_shared<RenderScene>(cardUnderALamp())};
  std::vector<Camera> cameras;
  TilePool pool{2};
  Renderer renderer{{}};
  Frame before{kPixels, 3, 1}, end{kPixels, 3, 1};
  PointSampler sampler;
  KnownRays known;
  std::vector<PointSample> points{kPixels};
  std::vector<PlaceLight> light{kPixels};
};

// A point has the visibility of its pixel in a frame, by the same rays; and where the penumbra ends it is 0
// or 1.
TEST_F(PointShadows, AreThoseOfFrames) {
  std::vector<RaysAround> none(kPixels);
  lookAt(0, none);
  EXPECT_EQ(light[0].visibility, 0.5f) << "rays cannot tell it";
  EXPECT_EQ(none[0].own, KnownRays::kNone);
  int between = 0;
  for (int x = 1; x < kPixels; ++x) {
    const auto k = static_cast<std::size_t>(x);
    const RayVisibility& there = end.surfaces->shadows()[end.surfaces->indexOf(x, 1)].now;
    const float seen = std::clamp((kHalf + points[k].place.position.x) / (2 * kHalf), 0.f, 1.f);
    EXPECT_NEAR(light[k].visibility, 0.5f + there.trust * (there.mean - 0.5f), 1e-6f) << x;
    EXPECT_NEAR(light[k].visibility, seen, 0.3f) << x;
    between += light[k].visibility > 0.05f && light[k].visibility < 0.95f;
  }
  EXPECT_GT(between, 10);
}

// The edge of a card passes each ray once. So a ray that ends alike before and after does so between, and no
// light is lost with it.
TEST_F(PointShadows, RaysThatEndAlikeBeforeAndAfterAreNotTraced) {
  std::vector<RaysAround> first(kPixels), last(kPixels), middle(kPixels), none(kPixels);
  lookAt(0, first), lookAt(2, last);
  const std::size_t all = lookAt(1, none);
  const std::vector<PlaceLight> truth = light;
  for (std::size_t k = 0; k < kPixels; ++k) middle[k] = {first[k].own, last[k].own};
  const std::size_t traced = lookAt(1, middle);
  for (std::size_t k = 0; k < kPixels; ++k) EXPECT_NEAR(light[k].visibility, truth[k].visibility, 1e-6f) << k;
  EXPECT_GT(all, 200u);
  EXPECT_GT(traced, 0u);
  EXPECT_LT(traced, all / 20);
}

}  // namespace
}  // namespace saccade
