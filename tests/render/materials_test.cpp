// Materials in a scene: energy, masks, bumps, sides, and the choice of a kernel.
#include <gtest/gtest.h>

#include "render/render_mean.h"
#include "render/test_scenes.h"
#include "render/world/surface_at.h"

namespace saccade {
namespace {

Material of(BsdfKind kind, float alpha = 0.3f) {
  Material m = test::grey(0.5f);
  m.model.kind = kind;
  m.model.alpha = alpha;
  return m;
}

// A ball that fills the view, under a sky of radiance 1.
Scene ball(const Material& m) {
  Scene s;
  s.materials = {m};
  s.spheres = {{"ball", {0, 0, 3}, 1, 0, {}}};
  s.environment = {{1, 1, 1}, {}, {}};
  s.fov_x_deg = 8;
  return s;
}

// A surface that loses no light cannot be told from the sky.
TEST(Materials, WithoutLossVanishInAFurnace) {
  for (const BsdfKind kind : {BsdfKind::kConductor, BsdfKind::kDielectric, BsdfKind::kThinDielectric}) {
    const test::Mean m = test::renderMean(ball(of(kind)), 0, 256);
    EXPECT_NEAR(m.mean, 1, 4 * m.error + 1e-3) << static_cast<int>(kind);
  }
}

Material metallicRoughness(Rgb base, float roughness, float metalness) {
  Material m = of(BsdfKind::kMetallicRoughness);
  m.reflectance = constantColor(base);
  m.metallic_roughness = constantColor({0, roughness, metalness});
  return m;
}

TEST(Materials, OfWhiteGltfVanishInAFurnace) {
  for (const float roughness : {0.2f, 0.6f, 1.f}) {
    const test::Mean m = test::renderMean(ball(metallicRoughness({1, 1, 1}, roughness, 0)), 0, 256, 64);
    EXPECT_NEAR(m.mean, 1, 4 * m.error + 1e-3) << roughness;
  }
}

TEST(Materials, OfGltfReflectTheirAlbedoInAFurnace) {
  for (const float metalness : {0.f, 0.5f, 1.f}) {
    const Frame frame =
        test::renderFrame(ball(metallicRoughness({0.5f, 0.5f, 0.5f}, 0.5f, metalness)), 0, 1024, 16);
    const test::Mean m = test::meanOf(frame.samples.I2);
    EXPECT_NEAR(m.mean / test::meanOf(frame.g.albedo).mean, 1, 4 * m.error / m.mean + 2e-3) << metalness;
  }
}

// Head-on: the albedo that the filter divides by is what comes back.
TEST(Materials, ReflectTheirAlbedoInAFurnace) {
  for (const BsdfKind kind :
       {BsdfKind::kDiffuse, BsdfKind::kPlastic, BsdfKind::kRoughPlastic, BsdfKind::kRoughConductor}) {
    const Frame frame = test::renderFrame(ball(of(kind)), 0, 1024, 16);
    const test::Mean m = test::meanOf(frame.samples.I2);
    EXPECT_NEAR(m.mean / test::meanOf(frame.g.albedo).mean, 1, 4 * m.error / m.mean + 2e-3)
        << static_cast<int>(kind);
  }
}

// A slab of glass before a lamp, head-on: (1 - f) / (1 + f) of it comes through, with all reflections inside.
TEST(Materials, ASlabOfGlassLetsLightThrough) {
  Scene scene = test::floorFromAbove(0);
  scene.meshes[0].radiance = {2, 2, 2};
  scene.materials.push_back(of(BsdfKind::kDielectric));
  scene.meshes.push_back(test::quad({-9, -9, 1.5f}, {18, 0, 0}, {0, 18, 0}, 1));  // facing the camera
  scene.meshes.push_back(test::quad({-9, -9, 1}, {0, 18, 0}, {18, 0, 0}, 1));     // facing the lamp
  const Frame frame = test::renderFrame(std::move(scene), 0, 1024);
  const test::Mean m = test::meanOf(frame.samples.I2);
  const double f = 0.04;
  EXPECT_NEAR(m.mean, 2 * (1 - f) / (1 + f), 4 * m.error);
  EXPECT_LT(m.error, 2e-3);
  EXPECT_NEAR(test::meanOf(frame.g.emission).mean, 2 * (1 - f) * (1 - f), 1e-3);  // straight through
}

// Head-on: what it reflects, and what comes through of a radiance that the index makes smaller.
TEST(Materials, RoughGlassIsLitFromBothSides) {
  Scene scene = test::floorFromAbove(0);
  scene.materials = {of(BsdfKind::kRoughDielectric)};
  scene.environment = {{1, 1, 1}, {}, {}};
  const BsdfTables tables(scene.materials[0].model);
  const double through = tables.transmittance(1) / (tables.model.ior * tables.model.ior);
  const test::Mean m = test::renderMean(std::move(scene), 0, 1024);
  EXPECT_NEAR(m.mean, tables.reflectance(1).x + through, 4 * m.error + 5e-3);
}

// By the value of the BSDF, straight through from a lamp without extent.
TEST(Materials, APointShinesThroughRoughGlass) {
  Scene scene = test::floorFromAbove(0);
  scene.materials = {of(BsdfKind::kRoughDielectric)};
  scene.point_lights = {{{0, 0, -200}, {4e4f, 4e4f, 4e4f}}};  // irradiance 1 on the glass
  const BsdfTables tables(scene.materials[0].model);
  const Bsdf glass{&tables};
  const double expected = evaluateBsdf(glass, Vec3{0, 0, 1}, Vec3{0, 0, -1}).value.x;
  EXPECT_NEAR(test::renderMean(std::move(scene), 0, 64, 16).mean, expected, 0.01 * expected);
}

TEST(Materials, AMaskShowsItsShare) {
  Material m = test::grey(0.5f);
  m.opacity.color0 = {0.75f, 0.75f, 0.75f};
  Scene scene = test::floorFromAbove(0);
  scene.materials = {m};
  scene.environment = {{1, 1, 1}, {}, {}};
  const test::Mean mean = test::renderMean(std::move(scene), 0, 1024);
  EXPECT_NEAR(mean.mean, 0.75 * 0.5 + 0.25, 4 * mean.error);
}

// Height x on a floor: the normal leans back by 45 degrees; 16 texels are one unit of length each.
TEST(Materials, ABumpMapBendsTheNormal) {
  Scene scene = test::floorFromAbove(0.5f);
  std::vector<Rgb> ramp;
  for (int i = 0; i < 16 * 16; ++i) ramp.push_back(Rgb{1, 1, 1} * (static_cast<float>(i % 16) / 16));
  scene.textures.emplace_back(16, 16, ramp);
  Material& m = scene.materials[0];
  m.height.kind = SurfaceColor::Kind::kBitmap;
  m.height.texture = 0;
  m.height_scale = 10;
  const PosedScene s(std::make_shared<RenderScene>(scene));
  const Ray ray{{0.3f, 0.2f, 1}, {0, 0, -1}, 9};
  const Surface at = surfaceAt<kEverything>(s, ray, s.still().geometry().intersect(ray), 0.001f);
  EXPECT_NEAR(at.shading_normal.x, -std::sqrt(0.5), 1e-3);
  EXPECT_NEAR(at.shading_normal.y, 0, 1e-3);
  EXPECT_EQ(at.geometric_normal.z, 1);
}

TEST(Materials, MetalIsBlackFromBehindAndGlassIsNot) {
  for (const auto& [kind, seen] : {std::pair{BsdfKind::kConductor, 0.}, {BsdfKind::kThinDielectric, 1.}}) {
    Scene scene = test::floorFromAbove(0);
    scene.materials = {of(kind)};
    scene.materials[0].twosided = false;
    scene.environment = {{1, 1, 1}, {}, {}};
    scene.T_world_camera = {{0, 0, -3}, {}};
    EXPECT_NEAR(test::renderMean(std::move(scene), 0, 64, 8).mean, seen, 0.05);
  }
}

Shading kernelOf(const Scene& scene) {
  return withKernel(shadingOf(scene), []<Shading S>() { return S; });
}

// A scene gets the smallest kernel, and every kernel gives the same picture.
TEST(Kernels, AreTheSmallestThatHoldTheScene) {
  Scene scene = test::furnace(0.5f, 1);
  EXPECT_EQ(kernelOf(scene), kPlainDiffuse);
  Scene textured = scene, all = scene;
  textured.materials.push_back(test::grey(0.1f));
  textured.materials.back().reflectance.kind = SurfaceColor::Kind::kCheckerboard;
  all.materials.push_back(of(BsdfKind::kConductor));
  EXPECT_EQ(kernelOf(textured), kTexturedDiffuse);
  EXPECT_EQ(kernelOf(all), kEverything);
  const Frame a = test::renderFrame(scene, 3, 2), b = test::renderFrame(textured, 3, 2),
              c = test::renderFrame(all, 3, 2);
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      ASSERT_FLOAT_EQ(a.samples.I2.at(x, y), b.samples.I2.at(x, y));
      ASSERT_NEAR(a.samples.I2.at(x, y), c.samples.I2.at(x, y), 1e-4f * a.samples.I2.at(x, y));
    }
  }
}

// The kernel of a scene of plastics need not know other features; a sky or a mask brings in no other BSDF.
TEST(Kernels, OfPlasticsKnowNoMetalsAndNoGlass) {
  Scene plastic = test::furnace(0.5f, 1), sky = plastic, lamp = plastic, mask = plastic;
  plastic.materials.push_back(of(BsdfKind::kRoughPlastic));
  sky.environment = {{1, 1, 1}, {}, {}};
  lamp.point_lights.push_back({});
  mask.materials[0].opacity.color0 = {0.5f, 0.5f, 0.5f};
  for (const Scene& scene : {plastic, sky, lamp, mask}) EXPECT_EQ(kernelOf(scene), kPlastics);
  for (const BsdfKind kind :
       {BsdfKind::kConductor, BsdfKind::kRoughConductor, BsdfKind::kDielectric, BsdfKind::kThinDielectric})
    EXPECT_EQ(kPlastics.kinds & only(kind), 0u);
}

}  // namespace
}  // namespace saccade
