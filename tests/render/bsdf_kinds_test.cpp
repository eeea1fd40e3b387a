// Rules for each kind of BSDF, and the choice between them.
#include <gtest/gtest.h>

#include "render/bsdf/bsdf.h"
#include "render/bsdf/shading_frame.h"
#include "render/bsdf_cases.h"

namespace saccade {
namespace {

// A kernel of an all-diffuse scene does not even look at the kind.
TEST(BsdfKinds, OfADiffuseSceneNothingElseIsRead) {
  constexpr BsdfKinds kDiffuseOnly = only(BsdfKind::kDiffuse);
  const Bsdf b{nullptr, {0.8f, 0.4f, 0.1f}};
  const Vec3 wo = test::directionAt(0.5), wi = test::directionAt(0.25, 1);
  EXPECT_FLOAT_EQ(evaluateBsdf<kDiffuseOnly>(b, wo, wi).value.x, 0.8f * 0.25f * kInvPi);
  EXPECT_EQ(sampleBsdf<kDiffuseOnly>(b, wo, 0.3f, 0.4f, 0.5f).weight, (Rgb{0.8f, 0.4f, 0.1f}));
  EXPECT_EQ(bsdfAlbedo<kDiffuseOnly>(b, 0.5f).z, 0.1f);
}

TEST(BsdfKinds, AreThemselvesInAnySetThatHasThem) {
  constexpr BsdfKinds kTwo = only(BsdfKind::kDielectric) | only(BsdfKind::kPlastic);
  for (const test::BsdfCase& c : test::smoothCases()) {
    if (!(kTwo & only(c.tables.model.kind))) continue;
    EXPECT_LT(length(bsdfAlbedo<kTwo>(c.bsdf(), 0.5f) - bsdfAlbedo(c.bsdf(), 0.5f)), 1e-6f) << c.name;
  }
}

// Sampling is by the cosine, so that every weight is the albedo.
TEST(BsdfKinds, DiffuseIsCosineWeighted) {
  const BsdfTables tables(test::modelOf(BsdfKind::kDiffuse));
  const Bsdf b{&tables, {0.5f, 0.6f, 0.7f}};
  const BsdfSample s = sampleBsdf(b, {0, 0, 1}, 0.9f, 0.4f, 0.6f);
  EXPECT_NEAR(length(s.wi), 1, 1e-6);
  EXPECT_FLOAT_EQ(s.pdf * std::numbers::pi_v<float>, s.wi.z);
  EXPECT_EQ(s.weight, b.diffuse);
}

TEST(ShadingFrame, IsARotationThatTakesZToTheNormal) {
  for (const Vec3 n :
       {Vec3{0, 0, 1}, Vec3{0, 0, -1}, test::directionAt(0.3, 4), test::directionAt(-0.999, 1)}) {
    const ShadingFrame frame(n);
    const Vec3 w = test::directionAt(0.4, 5), back = frame.toLocal(frame.toWorld(w));
    EXPECT_NEAR(length(back - w), 0, 1e-6);
    EXPECT_NEAR(length(cross(frame.x, frame.y) - n), 0, 1e-6);
    EXPECT_EQ(frame.toWorld({0, 0, 1}), n);
  }
}

// f(wo, wi) = f(wi, wo).
TEST(BsdfKinds, AreReciprocal) {
  std::vector<test::BsdfCase> cases = test::smoothCases();
  for (test::BsdfCase& c : test::roughCases({0.1f, 0.5f})) cases.push_back(std::move(c));
  for (test::BsdfCase& c : test::metallicRoughnessCases({0.3f, 0.7f})) cases.push_back(std::move(c));
  for (test::BsdfCase& c : test::glossCases({0.1f, 0.5f})) cases.push_back(std::move(c));
  for (test::BsdfCase& c : test::coatedCases({0.1f, 0.5f})) cases.push_back(std::move(c));
  for (const test::BsdfCase& c : cases) {
    for (std::uint64_t i = 0; i < 200; ++i) {
      const double cos_o = 0.05 + 0.95 * test::uniformAt(1, i), cos_i = 0.05 + 0.95 * test::uniformAt(2, i);
      const Vec3 wo = test::directionAt(cos_o),
                 wi = test::directionAt(cos_i, 3 + 0.5 * test::uniformAt(3, i));
      const double there = evaluateBsdf(c.bsdf(), wo, wi).value.y / wi.z;
      const double back = evaluateBsdf(c.bsdf(), wi, wo).value.y / wo.z;
      ASSERT_NEAR(there, back, 2e-4 * std::abs(there) + 1e-6) << c.name;
    }
  }
}

// Each rough kind at almost no roughness reflects what its smooth kind does.
TEST(BsdfKinds, RoughKindsTendToTheSmoothOnes) {
  for (const test::BsdfCase& c : test::roughCases({1e-3f})) {
    BsdfModel smooth = c.tables.model;
    smooth.kind = smooth.kind == BsdfKind::kRoughPlastic ? BsdfKind::kPlastic : BsdfKind::kConductor;
    const BsdfTables tables(smooth);
    for (const float cos_o : {0.1f, 0.5f, 1.f}) {
      const Rgb expected = bsdfAlbedo({&tables, c.diffuse, c.specular}, cos_o),
                albedo = bsdfAlbedo(c.bsdf(), cos_o);
      EXPECT_NEAR(albedo.x, expected.x, 2e-3f) << c.name << " from " << cos_o;
      EXPECT_NEAR(albedo.z, expected.z, 2e-3f) << c.name << " from " << cos_o;
    }
  }
}

// A lobe that exists is chosen with a probability of 0.05 at least; one that does not, never.
TEST(BsdfKinds, ChooseEachLobeOften) {
  const BsdfTables plastic(test::modelOf(BsdfKind::kPlastic)), glass(test::modelOf(BsdfKind::kDielectric));
  const auto lobe = [](const Bsdf& b, Vec3 wo, float u_lobe) {
    return sampleBsdf(b, wo, u_lobe, 0.5f, 0.5f);
  };
  const Vec3 wo = test::directionAt(0.9), grazing = test::directionAt(1e-3), inside = test::directionAt(-0.2);
  const Rgb white{1, 1, 1}, faint{1e-3f, 1e-3f, 1e-3f}, none{};
  EXPECT_TRUE(lobe({&plastic, white, faint}, wo, 0.049f).delta);
  EXPECT_FALSE(lobe({&plastic, white, faint}, wo, 0.051f).delta);
  EXPECT_FALSE(lobe({&plastic, white, none}, wo, 0).delta);
  EXPECT_TRUE(lobe({&plastic, none, faint}, wo, 0.999f).delta);
  EXPECT_TRUE(lobe({&glass, none, white, white}, grazing, 0.951f).transmitted);
  EXPECT_FALSE(lobe({&glass, none, white, white}, grazing, 0.949f).transmitted);
  EXPECT_FALSE(lobe({&glass, none, white, none}, wo, 0.999f).transmitted);
  EXPECT_FALSE(lobe({&glass, none, white, white}, inside, 0.999f).transmitted);  // total internal reflection
}

}  // namespace
}  // namespace saccade
