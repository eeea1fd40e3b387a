#include "render/bsdf/fresnel.h"

#include <gtest/gtest.h>

namespace saccade {
namespace {

TEST(DielectricFresnel, AtNormalIncidence) {
  for (const float n : {0.5f, 1 / 1.5f, 1.33f, 1.5f, 2.4f})
    EXPECT_NEAR(fresnelDielectric(1.f, n).reflectance, std::pow((n - 1) / (n + 1), 2), 1e-6) << n;
}

// Brewster: at tan(i) = n nothing of the one polarisation is reflected, and (n^2-1)^2 / (n^2+1)^2 of the
// other.
TEST(DielectricFresnel, AtBrewstersAngle) {
  for (const double n : {1 / 1.5, 1.33, 1.5, 2.4}) {
    const double cos_i = 1 / std::sqrt(1 + n * n), other = std::pow((n * n - 1) / (n * n + 1), 2);
    const auto r = fresnelDielectric(static_cast<float>(cos_i), static_cast<float>(n));
    EXPECT_NEAR(r.reflectance, other / 2, 1e-6) << n;
    EXPECT_NEAR(r.cos_t, std::sqrt(1 - cos_i * cos_i), 1e-6) << n;  // at a right angle to what is reflected
  }
}

// Beyond sin(i) = n all is reflected, just before it not.
TEST(DielectricFresnel, AtTheCriticalAngle) {
  const double n = 1 / 1.5, cos_critical = std::sqrt(1 - n * n);
  EXPECT_EQ(fresnelDielectric(static_cast<float>(cos_critical - 1e-3), static_cast<float>(n)).reflectance, 1);
  EXPECT_EQ(fresnelDielectric(static_cast<float>(cos_critical - 1e-3), static_cast<float>(n)).cos_t, 0);
  EXPECT_LT(fresnelDielectric(static_cast<float>(cos_critical + 1e-3), static_cast<float>(n)).reflectance,
            0.9f);
}

TEST(DielectricFresnel, AlongTheSurfaceAllIsReflected) {
  for (const float n : {0.5f, 1 / 1.5f, 1.f, 1.5f}) EXPECT_EQ(fresnelDielectric(0.f, n).reflectance, 1) << n;
}

// From either side of an interface the same fraction is reflected (Stokes).
TEST(DielectricFresnel, IsTheSameFromBothSides) {
  for (float cos_i = 0.05f; cos_i <= 1; cos_i += 0.05f) {
    const auto in = fresnelDielectric(cos_i, 1.5f), out = fresnelDielectric(in.cos_t, 1 / 1.5f);
    EXPECT_NEAR(in.reflectance, out.reflectance, 1e-5);
    EXPECT_NEAR(out.cos_t, cos_i, 1e-5);
  }
}

TEST(ConductorFresnel, AtNormalAndGrazingIncidence) {
  for (const auto& [eta, k] : {std::pair{0.2f, 3.9f}, {1.1f, 2.14f}, {4.4f, 5.2f}}) {
    const double normal = (std::pow(eta - 1, 2) + k * k) / (std::pow(eta + 1, 2) + k * k);
    EXPECT_NEAR(fresnelConductor(1, eta, k), normal, 1e-6);
    EXPECT_EQ(fresnelConductor(0, eta, k), 1);
  }
}

TEST(ConductorFresnel, WithoutAbsorptionIsTheDielectrics) {
  for (float cos_i = 0.05f; cos_i <= 1; cos_i += 0.05f)
    EXPECT_NEAR(fresnelConductor(cos_i, 1.5f, 0), fresnelDielectric(cos_i, 1.5f).reflectance, 1e-6) << cos_i;
}

// In the limit of a perfect conductor, and for the index that scene files call "none", all is reflected.
TEST(ConductorFresnel, PerfectConductorsReflectAll) {
  for (const float cos_i : {0.01f, 0.3f, 1.f}) {
    EXPECT_NEAR(fresnelConductor(cos_i, 1, 1e6f), 1, 1e-3);
    EXPECT_EQ(fresnelConductor(cos_i, 0, 1), 1);
  }
}

}  // namespace
}  // namespace saccade
