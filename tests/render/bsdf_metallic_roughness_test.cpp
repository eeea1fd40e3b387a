// The metallic-roughness material against closed forms.
#include <gtest/gtest.h>

#include "render/bsdf_cases.h"

namespace saccade {
namespace {

constexpr float kCosines[] = {0.05f, 0.2f, 0.6f, 1.f};

// glTF 2.0, B.3.5: f0 of what is no metal is 0.04, and that of a metal is its colour.
TEST(MetallicRoughness, ReflectsAtARightAngleWhatGltfSays) {
  const BsdfTables tables(test::modelOf(BsdfKind::kMetallicRoughness));
  const Rgb base{0.9f, 0.5f, 0.2f};
  const Bsdf plain = MetallicRoughness::at(tables, base, {0, 0.5f, 0});
  EXPECT_NEAR(plain.specular.x, 0.04f, 1e-6f);
  EXPECT_EQ(plain.diffuse, base);
  const Bsdf metal = MetallicRoughness::at(tables, base, {0, 0.5f, 1});
  EXPECT_EQ(metal.specular, base);
  EXPECT_EQ(metal.diffuse, Rgb{});
  const Bsdf mixed = MetallicRoughness::at(tables, base, {0, 0.5f, 0.25f});
  EXPECT_NEAR(mixed.specular.y, 0.75f * 0.04f + 0.25f * 0.5f, 1e-6f);
  EXPECT_NEAR(mixed.diffuse.y, 0.75f * 0.5f, 1e-6f);
  EXPECT_EQ(mixed.alpha, 0.25f);
}

// F D G / (4 cos_o cos_i), as glTF 2.0 has them in B.2.3 and B.3.4, but for the height correlation of G.
TEST(MetallicRoughness, OfAMetalIsTheMicrofacetFormula) {
  const test::BsdfCase metal = test::metallicRoughness({0.9f, 0.5f, 0.2f}, 0.6f, 1);
  const Vec3 wo = test::directionAt(0.3), wi = test::directionAt(0.8, 2), h = normalize(wo + wi);
  const double a2 = std::pow(0.6, 4), n = h.z * h.z * (a2 - 1) + 1;
  const double d = a2 / (std::numbers::pi * n * n), f = 0.5 + 0.5 * std::pow(1 - dot(wo, h), 5);
  const auto g1 = [&](double cosine) {
    return 2 * cosine / (cosine + std::sqrt(a2 + (1 - a2) * cosine * cosine));
  };
  const double expected = f * d * g1(wo.z) * g1(wi.z) / (4 * wo.z);
  EXPECT_NEAR(evaluateBsdf(metal.bsdf(), wo, wi).value.y, expected, 1e-4 * expected);
}

// A white dielectric reflects all light. So does a smooth mixture, without loss between its microfacets.
TEST(MetallicRoughness, OfWhiteReflectsAllLight) {
  for (const float roughness : {0.f, 0.2f, 0.5f, 1.f})
    for (const float cos_o : kCosines) {
      const test::BsdfCase white = test::metallicRoughness({1, 1, 1}, roughness, 0);
      EXPECT_NEAR(bsdfAlbedo(white.bsdf(), cos_o).x, 1, 1e-5) << roughness << " from " << cos_o;
    }
  const test::BsdfCase smooth = test::metallicRoughness({1, 1, 1}, 0.01f, 0.5f);
  EXPECT_NEAR(bsdfAlbedo(smooth.bsdf(), 0.8f).x, 1, 1e-4);
}

TEST(MetallicRoughness, ReflectsNoMoreThanItGets) {
  for (const float ior : {1.f, 1.05f, 1.2f, 1.5f, 2.5f})
    for (const float metalness : {0.f, 0.02f, 0.3f, 0.9f, 1.f})
      for (const float roughness : {0.f, 0.1f, 0.4f, 1.f})
        for (const float cos_o : kCosines) {
          const test::BsdfCase white = test::metallicRoughness({1, 1, 1}, roughness, metalness, ior);
          EXPECT_LE(bsdfAlbedo(white.bsdf(), cos_o).x, 1.0001f) << white.name << " from " << cos_o;
        }
}

// The light that a smooth surface reflects is Schlick's formula.
TEST(MetallicRoughness, OfASmoothSurfaceIsSchlicksFormula) {
  const test::BsdfCase metal = test::metallicRoughness({0.9f, 0.5f, 0.2f}, 0, 1);
  for (const float cos_o : {0.3f, 0.7f, 1.f})
    EXPECT_NEAR(bsdfAlbedo(metal.bsdf(), cos_o).y, 0.5 + 0.5 * std::pow(1 - cos_o, 5), 3e-3) << cos_o;
}

TEST(MetallicRoughness, HasABaseUnlessItIsAMetal) {
  EXPECT_TRUE(bsdfHasBase(test::metallicRoughness({0.5f, 0.5f, 0.5f}, 0.5f, 0).bsdf()));
  EXPECT_FALSE(bsdfHasBase(test::metallicRoughness({0.5f, 0.5f, 0.5f}, 0.5f, 1).bsdf()));
}

}  // namespace
}  // namespace saccade
