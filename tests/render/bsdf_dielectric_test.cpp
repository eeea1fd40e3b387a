// Glass against closed forms.
#include <gtest/gtest.h>

#include "render/bsdf_cases.h"

namespace saccade {
namespace {

// Snell: what goes in at sin = 0.6 goes on at sin = 0.6 / 1.5 in the same plane, and out again the same way.
TEST(Dielectric, Refracts) {
  const BsdfTables glass(test::modelOf(BsdfKind::kDielectric));
  const Bsdf b{&glass, {}, {0, 0, 0}};
  const BsdfSample in = sampleBsdf(b, {0.6f, 0, 0.8f}, 0.99f, 0, 0);
  EXPECT_NEAR(length(in.wi - Vec3{-0.4f, 0, -std::sqrt(1 - 0.16f)}), 0, 1e-6);
  const BsdfSample out = sampleBsdf(b, in.wi, 0.99f, 0, 0);
  EXPECT_NEAR(length(out.wi - Vec3{0.6f, 0, 0.8f}), 0, 1e-6);
  const float through = 1 - fresnelDielectric(0.8f, 1.5f).reflectance;
  EXPECT_NEAR(in.weight.x, through / 2.25f, 1e-6);
  EXPECT_NEAR(out.weight.x, through * 2.25f, 1e-5);
}

// A pane of reflectance 0.04 a surface: 0.04 + 0.96^2 (0.04 + 0.04^3 + ...) = 0.08 / 1.04. The rest goes
// straight on.
TEST(ThinDielectric, ReflectsBetweenItsSurfaces) {
  const BsdfTables pane(test::modelOf(BsdfKind::kThinDielectric));
  const Rgb reflected = bsdfAlbedo({&pane, {}, {1, 1, 1}, {}}, 1), through = bsdfAlbedo({&pane, {}, {}}, -1);
  EXPECT_NEAR(reflected.x, 0.08 / 1.04, 1e-6);
  EXPECT_NEAR(through.x, 0.96 / 1.04, 1e-6);
  const Vec3 wo = test::directionAt(-0.4, 2);
  EXPECT_EQ(sampleBsdf({&pane}, wo, 0.99f, 0, 0).wi, -wo);
}

}  // namespace
}  // namespace saccade
