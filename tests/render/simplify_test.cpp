#include "render/features/simplify.h"

#include <gtest/gtest.h>

#include "scene/mesh/mesh.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

constexpr Rgb grey(float v) {
  return {v, v, v};
}

SurfaceColor bitmap(int texture) {
  SurfaceColor c;
  c.kind = SurfaceColor::Kind::kBitmap;
  c.texture = texture;
  return c;
}
SurfaceColor checkerboard(Rgb a, Rgb b) {
  SurfaceColor c;
  c.kind = SurfaceColor::Kind::kCheckerboard;
  c.color0 = a, c.color1 = b;
  return c;
}

Texture picture(const std::vector<Rgb>& pixels) {
  return Texture(static_cast<int>(pixels.size()), 1, pixels);
}

// A square of one material.
Scene square(const Material& material) {
  Scene scene;
  scene.materials = {material};
  scene.meshes = {makeRectangle()};
  return scene;
}
Scene square(BsdfModel model, Rgb reflectance = {}, Rgb specular = grey(1)) {
  Material m;
  m.model = model;
  m.reflectance = constantColor(reflectance), m.specular = constantColor(specular);
  return square(m);
}

const Material& first(const Scene& scene) {
  return scene.materials.at(0);
}

void expectColor(const SurfaceColor& c, Rgb expected, double tolerance = 1e-6) {
  EXPECT_EQ(c.kind, SurfaceColor::Kind::kConstant);
  expectNear(c.color0, expected, tolerance);
}

void expectDiffuse(const Scene& scene, Rgb albedo, double tolerance = 1e-6) {
  EXPECT_EQ(first(scene).model.kind, BsdfKind::kDiffuse);
  expectColor(first(scene).reflectance, albedo, tolerance);
  EXPECT_EQ(scene.meshes.size(), 1u);
}

TEST(Simplify, APartIsThereWhereAMaterialHasIt) {
  EXPECT_EQ(featuresOf(square(BsdfModel{})), SceneFeatures{});
  Material m;
  m.specular = checkerboard(grey(0), grey(1));
  m.model.kind = BsdfKind::kPlastic;
  m.opacity = constantColor(grey(0.5f));
  m.height = bitmap(0);
  Scene scene = square(m);
  scene.textures = {picture({grey(0), grey(1)})};
  scene.environment = Environment{grey(1), {1, 1, {grey(1)}}, {}};
  EXPECT_EQ(featuresOf(scene),
            (SceneFeatures{SceneFeature::kTextures, SceneFeature::kSpecular, SceneFeature::kBumpMaps,
                           SceneFeature::kMasks, SceneFeature::kEnvironment, SceneFeature::kMipFiltering}));
  for (const SceneFeatureInfo& info : featureTable())
    EXPECT_EQ(featuresOf(simplified(scene, {info.feature})).count(info.feature), 0u) << info.name;
}

TEST(Simplify, NothingLeftOutLeavesAllAsItIs) {
  Material m;
  m.reflectance = bitmap(0), m.opacity = constantColor(grey(0.2f));
  Scene scene = square(m);
  scene.textures = {picture({grey(0), grey(1)})};
  const Scene same = simplified(scene, {});
  EXPECT_EQ(featuresOf(same), featuresOf(scene));
  EXPECT_EQ(same.textures.size(), 1u);
  EXPECT_EQ(same.meshes.size(), 1u);
}

TEST(Simplify, TexturesBecomeTheirMeanAndAreGone) {
  Material m;
  m.reflectance = bitmap(1);
  m.specular = checkerboard({1, 0, 0}, {0, 0.5f, 0});
  m.opacity = bitmap(2);  // is no part of the colours
  Scene scene = square(m);
  scene.textures = {picture({grey(1)}), picture({{0.25f, 0, 1}, {0.75f, 0.5f, 1}}), picture({grey(0.5f)})};
  const Scene plain = simplified(scene, {SceneFeature::kTextures});
  expectColor(first(plain).reflectance, {0.5f, 0.25f, 1});
  expectColor(first(plain).specular, {0.5f, 0.25f, 0});
  ASSERT_EQ(plain.textures.size(), 1u);
  EXPECT_EQ(first(plain).opacity.texture, 0);
  EXPECT_EQ(plain.textures[0].mean().x, 0.5f);
}

// At a right angle an interface reflects ((ior - 1) / (ior + 1))^2.
// The mesh keeps the mean light.
TEST(Simplify, ALampShinesAlikeAllOver) {
  Material m;
  m.emission = bitmap(0);
  Scene scene = square(m);
  scene.meshes[0].radiance = grey(3);
  scene.textures = {picture({grey(0.5f), grey(1.5f)})};
  EXPECT_TRUE(featuresOf(scene).contains(SceneFeature::kTextures));
  const Scene plain = simplified(scene, {SceneFeature::kTextures});
  expectColor(first(plain).emission, grey(1));
  EXPECT_EQ(plain.meshes[0].radiance, grey(3));
  EXPECT_TRUE(plain.textures.empty());
}

// A changed picture wraps as the first one does.
TEST(Simplify, APictureKeepsItsEdges) {
  Material m;
  m.model.kind = BsdfKind::kConductor;
  m.specular = bitmap(0);
  Scene scene = square(m);
  scene.textures = {picture({grey(0), grey(1)})};
  scene.textures[0].setWrap(Texture::Wrap::kClamp, Texture::Wrap::kMirror);
  const Scene plain = simplified(scene, {SceneFeature::kSpecular});
  EXPECT_EQ(plain.textures.at(0).wrapU(), Texture::Wrap::kClamp);
  EXPECT_EQ(plain.textures.at(0).wrapV(), Texture::Wrap::kMirror);
}

TEST(Simplify, PlasticKeepsItsAlbedoAtARightAngle) {
  const double ior = 1.5, f = std::pow((ior - 1) / (ior + 1), 2);
  const auto expected = [&](double base, double specular) {
    return static_cast<float>(specular * f + base * (1 - f));
  };
  const Scene scene = square({.kind = BsdfKind::kPlastic, .ior = 1.5f}, {0.8f, 0.2f, 0}, {0.5f, 1, 1});
  expectDiffuse(simplified(scene, {SceneFeature::kSpecular}),
                {expected(0.8, 0.5), expected(0.2, 1), expected(0, 1)});
}

TEST(Simplify, APictureOnPlasticChangesPixelByPixel) {
  Material m;
  m.model = {.kind = BsdfKind::kPlastic, .ior = 1.5f};
  m.reflectance = bitmap(0);
  m.reflectance.uv_scale = {3, 2};
  Scene scene = square(m);
  scene.textures = {picture({grey(0), grey(1)})};
  const Scene matt = simplified(scene, {SceneFeature::kSpecular});
  EXPECT_EQ(first(matt).reflectance.uv_scale.x, 3);
  ASSERT_EQ(matt.textures.size(), 1u);
  EXPECT_NEAR(matt.textures[0].pixels()[0].x, 0.04, 1e-6);
  EXPECT_NEAR(matt.textures[0].pixels()[1].x, 1, 1e-6);
  EXPECT_EQ(scene.textures[0].pixels()[0].x, 0);
}

// ((eta - 1)^2 + k^2) / ((eta + 1)^2 + k^2) at a right angle.
TEST(Simplify, MetalsKeepTheirReflectance) {
  const Rgb eta{0.2f, 0.9f, 1.5f}, k{3.9f, 2.5f, 1.9f};
  const auto f = [](float n, float kappa) {
    return ((n - 1) * (n - 1) + kappa * kappa) / ((n + 1) * (n + 1) + kappa * kappa);
  };
  const Rgb reflectance{f(eta.x, k.x), f(eta.y, k.y), f(eta.z, k.z)};
  const BsdfModel mirror{.kind = BsdfKind::kConductor, .eta = eta, .k = k};
  expectDiffuse(simplified(square(mirror, {}, grey(0.5f)), {SceneFeature::kSpecular}), reflectance * 0.5f,
                1e-5);
  const BsdfModel rough{.kind = BsdfKind::kRoughConductor, .alpha = 0.05f, .eta = eta, .k = k};
  expectDiffuse(simplified(square(rough), {SceneFeature::kSpecular}), reflectance, 5e-3);
}

TEST(Simplify, GlassIsGoneButForLamps) {
  for (const BsdfKind kind : {BsdfKind::kDielectric, BsdfKind::kThinDielectric}) {
    Scene scene = square({.kind = kind});
    scene.meshes.push_back(makeCube());
    scene.meshes[1].radiance = grey(1);
    scene.spheres.resize(1);
    const Scene open = simplified(scene, {SceneFeature::kSpecular});
    EXPECT_TRUE(open.spheres.empty());
    ASSERT_EQ(open.meshes.size(), 1u);
    EXPECT_EQ(open.meshes[0].radiance, grey(1));
    expectDiffuse(open, {});
  }
}

TEST(Simplify, BumpMapsAreFlat) {
  Material m;
  m.height = checkerboard(grey(0), grey(1)), m.height_scale = 3;
  EXPECT_FALSE(isBumpy(first(simplified(square(m), {SceneFeature::kBumpMaps}))));
}

TEST(Simplify, MasksAreOpaqueFromAHalfOn) {
  const auto masked = [](SurfaceColor opacity) {
    Material m;
    m.opacity = opacity;
    Scene scene = square(m);
    scene.textures = {picture({grey(1), grey(0.1f)})};
    return simplified(scene, {SceneFeature::kMasks});
  };
  EXPECT_TRUE(masked(constantColor(grey(0.49f))).meshes.empty());
  EXPECT_TRUE(masked(checkerboard(grey(0), grey(0.9f))).meshes.empty());
  for (const Scene& scene : {masked(constantColor(grey(0.51f))), masked(bitmap(0))}) {
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_TRUE(isOpaque(first(scene)));
  }
}

// A bright row by one pole of three rows: a quarter of the sphere above 60 degrees, not a third of the
// pixels.
TEST(Simplify, AnEnvironmentBecomesItsMeanOverTheSphere) {
  Scene scene = square(BsdfModel{});
  scene.environment = Environment{{2, 2, 4}, {2, 3, std::vector<Rgb>(6)}, {}};
  scene.environment->picture.pixels[0] = scene.environment->picture.pixels[1] = grey(1);
  const Scene plain = simplified(scene, {SceneFeature::kEnvironment});
  expectNear(plain.environment->radiance, Rgb{0.5f, 0.5f, 1}, 1e-6);
  EXPECT_TRUE(plain.environment->picture.pixels.empty());
}

TEST(Simplify, WithoutMipFilteringAPictureIsLookedUpAtAPoint) {
  Material m;
  m.reflectance = bitmap(0);
  Scene scene = square(m);
  scene.textures = {picture({grey(0), grey(1)})};
  const Texture sharp = simplified(scene, {SceneFeature::kMipFiltering}).textures[0];
  for (const float footprint : {0.f, 0.7f, 1.f, 100.f})
    EXPECT_EQ(sharp.sample({0.75f, 0.5f}, footprint).x, 1);
  EXPECT_EQ(scene.textures[0].sample({0.75f, 0.5f}, 1).x, 0.5f);
}

// Textures get their mips where they are made.
TEST(Simplify, PartsGoTogether) {
  Material m;
  m.model.kind = BsdfKind::kPlastic;
  m.reflectance = bitmap(0);
  Scene scene = square(m);
  scene.textures = {picture({grey(0), grey(1)})};
  EXPECT_EQ(featuresOf(simplified(scene, {SceneFeature::kMipFiltering, SceneFeature::kSpecular})),
            SceneFeatures{SceneFeature::kTextures});
  EXPECT_EQ(featuresOf(simplified(scene, {SceneFeature::kTextures, SceneFeature::kSpecular})),
            SceneFeatures{});
}

TEST(Simplify, NamesOfPartsLeadToThem) {
  for (const SceneFeatureInfo& info : featureTable()) {
    ASSERT_NE(findFeature(info.name), nullptr);
    EXPECT_EQ(findFeature(info.name)->feature, info.feature);
    EXPECT_EQ(namesOf({info.feature}), std::vector{info.name});
  }
  EXPECT_EQ(findFeature("wings"), nullptr);
}

}  // namespace
}  // namespace saccade
