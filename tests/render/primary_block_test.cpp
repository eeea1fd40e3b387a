// Blocks of pixels in lanes, against the same pixels one by one: features, and where paths start.
#include "render/primary/primary_block.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/instruction_set.h"
#include "render/primary/gbuffer_pass.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

constexpr int kW = 23, kH = 17;  // no multiples of a block

// A room of plain surfaces of all kinds, with a mirror, and a gap that shows nothing.
Scene room() {
  Scene s;
  s.materials = {test::grey(0.6f), test::grey(0.5f), test::grey(0.7f, false), test::grey(0.5f)};
  s.materials[0].reflectance.color0 = {0.7f, 0.5f, 0.3f};
  s.materials[1].reflectance = {.kind = SurfaceColor::Kind::kCheckerboard,
                                .color0 = {0.9f, 0.1f, 0.2f},
                                .color1 = {0.1f, 0.8f, 0.3f},
                                .uv_scale = {4, 4}};
  s.materials[3].model.kind = BsdfKind::kConductor;
  s.meshes = {test::quad({-1, -1, 1}, {0, 2, 0}, {2, 0, 0}, 1),
              test::quad({-1, -1, -1}, {0, 2, 0}, {0, 0, 2}, 0),
              test::quad({1, -1, -1}, {0, 2, 0}, {0, 0, 2}, 2),  // its back is seen
              test::quad({-1, 1, -1}, {2, 0, 0}, {0, 0, 1.2f}, 0),
              test::quad({-0.3f, -0.95f, 0.2f}, {0.6f, 0, 0}, {0, 0, 0.6f}, 0, {9, 8, 7}),
              test::quad({-0.6f, 0.1f, 0.5f}, {0.4f, 0, 0.2f}, {0, 0.4f, 0}, 0),
              test::quad({0.2f, 0.3f, 0.6f}, {0.3f, 0, 0}, {0, 0.3f, 0}, 3)};
  Mesh& smooth = s.meshes[5];
  for (std::size_t i = 0; i + 1 < smooth.positions.size(); ++i)
    smooth.normals.push_back(normalize(Vec3{0.3f * static_cast<float>(i) - 0.4f, 0.2f, -1}));
  smooth.normals.push_back({});
  s.spheres.push_back({"ball", {0.4f, -0.3f, 0.4f}, 0.3f, 0, {}, {}});
  s.T_world_camera = {{0, 0, -0.9}, {}};
  s.fov_x_deg = 75;
  return s;
}

struct PrimaryBlockTest : testing::Test {
  PrimaryBlockTest()
      : scene(std::make_shared<RenderScene>(room())),
        now({{0, 0, -0.9}, {}}, pinhole(75, kW, kH)),
        before({{0.02, 0, -0.91}, {}}, pinhole(75, kW, kH)) {}

  // Calls check(block, lane, the same hit one by one) for each pixel, and returns how many are plain.
  int forEachPixel(const auto& trace, GBuffer& g, const auto& check) {
    const PixelContext view({scene, now}, {scene, before});
    int plain = 0;
    PrimaryBlock block;
    for (int y0 = 0; y0 < kH; y0 += kBlockEdge)
      for (int x0 = 0; x0 < kW; x0 += kBlockEdge) {
        const Tile pixels{x0, y0, std::min(x0 + kBlockEdge, kW), std::min(y0 + kBlockEdge, kH)};
        block.x0 = x0, block.y0 = y0;
        trace(view, pixels, g, block);
        EXPECT_FALSE((block.plain & block.others).any());
        EXPECT_EQ((block.plain | block.others).size(), (pixels.x1 - x0) * (pixels.y1 - y0));
        forEachLane(block.plain | block.others, [&](int lane) {
          const auto x = static_cast<float>(block.x(lane)), y = static_cast<float>(block.y(lane));
          const Ray ray{now.origin, now.direction(x, y), std::numeric_limits<float>::infinity()};
          PrimaryHit one;
          shadePrimary<kEverything>(view, ray, scene.still().geometry().intersect(ray), one);
          check(block, lane, one);
        });
        plain += block.plain.size();
      }
    return plain;
  }
  void expectSame(const auto& trace) {
    GBuffer together(kW, kH), alone(kW, kH);
    const int plain =
        forEachPixel(trace, together, [&](const PrimaryBlock& block, int lane, const PrimaryHit& one) {
          const int x = block.x(lane), y = block.y(lane);
          SCOPED_TRACE(testing::Message() << x << ", " << y);
          if (!block.plain.has(lane)) {
            const Hit& hit = block.hits[static_cast<std::size_t>(lane)];
            ASSERT_EQ(hit.valid, one.valid);
            return;
          }
          writeFeatures(one, now, before, x, y, alone);
          for (const auto plane : {&GBuffer::z, &GBuffer::dz, &GBuffer::nx, &GBuffer::ny, &GBuffer::nz,
                                   &GBuffer::albedo, &GBuffer::emission, &GBuffer::z_in_prev})
            EXPECT_NEAR((together.*plane).at(x, y), (alone.*plane).at(x, y), 1e-5);
          for (const auto plane : {&GBuffer::motion_x, &GBuffer::motion_y})
            EXPECT_NEAR((together.*plane).at(x, y), (alone.*plane).at(x, y), 1e-4);
          const PlainSurfaces& s = block.surfaces;
          const auto expectNear = [](Vec3 a, Vec3 b) { EXPECT_LT(length(a - b), 1e-5f); };
          expectNear(s.point.at(lane), one.start.surface.point);
          expectNear(s.geometric_normal.at(lane), one.start.surface.geometric_normal);
          expectNear(s.shading_normal.at(lane), one.start.surface.shading_normal);
          expectNear(s.reflectance.at(lane), one.start.surface.bsdf.diffuse);
          expectNear(s.emission.at(lane), one.guide.emission);
          EXPECT_NEAR(s.width[lane], one.start.cone.width, 1e-6f);
        });
    EXPECT_GT(plain, kW * kH / 2);
    EXPECT_LT(plain, kW * kH);
  }

  PosedScene scene;
  Camera now, before;
};

TEST_F(PrimaryBlockTest, IsTheSameInLanes) {
  expectSame(tracePrimaryBlockAvx2);
  if (widestInstructionSet() == InstructionSet::kAvx512) expectSame(tracePrimaryBlockAvx512);
}

// A camera that stands still moves nothing, to the last bit.
TEST_F(PrimaryBlockTest, GivesAStandingCameraNoMotion) {
  before = now;
  GBuffer g(kW, kH);
  forEachPixel(tracePrimaryBlock, g, [&](const PrimaryBlock& block, int lane, const PrimaryHit&) {
    if (!block.plain.has(lane)) return;
    EXPECT_EQ(g.motion_x.at(block.x(lane), block.y(lane)), 0);
    EXPECT_EQ(g.motion_y.at(block.x(lane), block.y(lane)), 0);
  });
}

// Pixels beside a block keep what they had.
TEST_F(PrimaryBlockTest, WritesItsOwnPixelsAlone) {
  GBuffer g(kW, kH);
  g.z.fill(-1);
  PrimaryBlock block;
  tracePrimaryBlock(PixelContext({scene, now}, {scene, before}), {8, 4, 11, 6}, g, block);
  for (int y = -1; y <= kH; ++y)
    for (int x = -1; x <= kW; ++x) {
      const bool inside = x >= 8 && x < 11 && y >= 4 && y < 6;
      ASSERT_EQ(g.z.at(x, y) != -1, inside) << x << ", " << y;
    }
}

}  // namespace
}  // namespace saccade
