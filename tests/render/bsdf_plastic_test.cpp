// Plastics against closed forms.
#include <gtest/gtest.h>

#include "render/bsdf_cases.h"

namespace saccade {
namespace {

BsdfTables plastic(BsdfKind kind, bool nonlinear, float ior = 1.5f) {
  BsdfModel m = test::modelOf(kind);
  m.nonlinear = nonlinear, m.ior = ior, m.alpha = 0.001f;
  return BsdfTables(m);
}

// Diffuse reflectance of a dielectric from outside, in closed form [Walsh 1926; Duderstadt and Martin 1979].
double diffuseFresnel(double n) {
  const double n2 = n * n, n4 = n2 * n2, a = (n - 1) / (n + 1);
  return 0.5 + (n - 1) * (3 * n + 1) / (6 * (n + 1) * (n + 1)) +
         n2 * (n2 - 1) * (n2 - 1) / std::pow(n2 + 1, 3) * std::log(a) -
         2 * n2 * n * (n2 + 2 * n - 1) / ((n2 + 1) * (n4 - 1)) +
         8 * n4 * (n4 + 1) / ((n2 + 1) * (n4 - 1) * (n4 - 1)) * std::log(n);
}

TEST(Plastic, LetsDiffuseLightThroughAsInClosedForm) {
  EXPECT_NEAR(diffuseFresnel(1.5), 0.0918, 1e-4);  // the formula itself, against Walsh's table
  for (const float n : {1.2f, 1.5f, 2.f}) {
    const BsdfTables tables = plastic(BsdfKind::kPlastic, true, n);
    EXPECT_NEAR(tables.mean_transmittance, 1 - diffuseFresnel(n), 1e-4) << n;
    EXPECT_NEAR(tables.internal_reflectance, 1 - (1 - diffuseFresnel(n)) / (n * n), 1e-4) << n;
  }
}

// The share that is left of a base of albedo a at an index of 1.5, measured on other people's renders. It is
// 0.404 a / (1 - 0.596 a) of the light that enters.
TEST(Plastic, NonlinearBaseIsDarkerThanItsReflectance) {
  for (const BsdfKind kind : {BsdfKind::kPlastic, BsdfKind::kRoughPlastic}) {
    const BsdfTables tables = plastic(kind, true);
    for (const float a : {0.1f, 0.5f, 0.9f}) {
      const Bsdf b{&tables, {a, a, a}, {0, 0, 0}};
      const float enters = 1 - fresnelDielectric(0.7f, 1.5f).reflectance;
      EXPECT_NEAR(bsdfAlbedo(b, 0.7f).x, enters * 0.404f * a / (1 - 0.596f * a), 1e-3f) << a;
    }
  }
}

// Without `nonlinear` the colour is that of the base.
TEST(Plastic, LinearBaseKeepsItsReflectance) {
  const BsdfTables tables = plastic(BsdfKind::kPlastic, false);
  const Bsdf b{&tables, {0.8f, 0.4f, 0.1f}, {0, 0, 0}};
  const Rgb albedo = bsdfAlbedo(b, 0.7f);
  const float enters = 1 - fresnelDielectric(0.7f, 1.5f).reflectance;
  EXPECT_NEAR(albedo.x, 0.8f * enters, 1e-5f);
  EXPECT_NEAR(albedo.z, 0.1f * enters, 1e-5f);
}

// Mitsuba's formula, term by term: a / (1 - a R) / ior^2 * T(o) T(i) / pi cos_i.
TEST(Plastic, DiffusePartIsMitsubas) {
  const BsdfTables tables = plastic(BsdfKind::kPlastic, true);
  const Vec3 wo = test::directionAt(0.3), wi = test::directionAt(0.8, 2);
  const double t_o = 1 - fresnelDielectric(0.3f, 1.5f).reflectance;
  const double t_i = 1 - fresnelDielectric(0.8f, 1.5f).reflectance;
  const double a = 0.6, r = 1 - (1 - diffuseFresnel(1.5)) / 2.25;
  const Bsdf b{&tables, {0.6f, 0.6f, 0.6f}};
  EXPECT_NEAR(evaluateBsdf(b, wo, wi).value.x, a / (1 - a * r) / 2.25 * t_o * t_i / std::numbers::pi * 0.8,
              1e-4);
}

// The transmission of a rough interface, from the BTDF [Walter 2007 (21)] by midpoints over all directions
// below it.
double integratedTransmittance(const Microfacets& f, Vec3 wo, float ior, int steps = 300) {
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double theta = (i + 0.5) / steps * std::numbers::pi / 2;
    for (int j = 0; j < steps; ++j) {
      const Vec3 wt = -test::directionAt(std::cos(theta), (j + 0.5) / steps * std::numbers::pi);
      const Vec3 h = normalize(-(wo + wt * ior));
      const double o = dot(wo, h), t = dot(wt, h), g = visibleFraction(f, wo) * visibleFraction(f, wt);
      if (o <= 0 || t >= 0 || h.z <= 0) continue;
      const double passed = 1 - fresnelDielectric(static_cast<float>(o), ior).reflectance;
      sum += passed * g * normalDensity(f, h) * std::abs(o * t) * ior * ior /
             (wo.z * std::pow(o + ior * t, 2)) * std::sin(theta);
    }
  }
  return sum * std::numbers::pi * std::numbers::pi / steps / steps;  // twice the half with y < 0
}

TEST(RoughPlastic, LetsThroughTheIntegralOfWaltersBtdf) {
  for (const MicrofacetKind kind : {MicrofacetKind::kBeckmann, MicrofacetKind::kGgx}) {
    for (const float alpha : {0.3f, 1.f}) {
      const BsdfTables tables(test::roughModel(BsdfKind::kRoughPlastic, kind, alpha));
      for (const float cos_o : {0.1f, 0.4f, 1.f})
        EXPECT_NEAR(tables.transmittance(cos_o),
                    integratedTransmittance({kind, alpha}, test::directionAt(cos_o), 1.5f), 5e-3)
            << alpha << " from " << cos_o;
    }
  }
}

}  // namespace
}  // namespace saccade
