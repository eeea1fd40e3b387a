#include "render/bsdf/microfacet.h"

#include <gtest/gtest.h>

#include "render/bsdf_cases.h"

namespace saccade {
namespace {

constexpr MicrofacetKind kKinds[] = {MicrofacetKind::kBeckmann, MicrofacetKind::kGgx};

// Integral over the upper hemisphere by midpoints in azimuth and in the polar angle.
template <class Function>
double integrate(Function at, int steps = 400) {
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double theta = (i + 0.5) / steps * std::numbers::pi / 2;
    for (int j = 0; j < steps; ++j)
      sum +=
          at(test::directionAt(std::cos(theta), (j + 0.5) / steps * 2 * std::numbers::pi)) * std::sin(theta);
  }
  return sum * std::numbers::pi * std::numbers::pi / steps / steps;
}

TEST(InverseErf, UndoesErf) {
  for (const float x : {-0.9999f, -0.99f, -0.5f, -1e-3f, 0.f, 0.1f, 0.7f, 0.999f})
    EXPECT_NEAR(std::erf(inverseErf(x)), x, 2e-7) << x;
}

// The microfacets together cover the surface as seen from above, once.
TEST(Microfacets, ProjectToTheSurface) {
  for (const MicrofacetKind kind : kKinds) {
    for (const float alpha : {0.1f, 0.4f, 1.f}) {
      const Microfacets f{kind, alpha};
      EXPECT_NEAR(integrate([&](Vec3 m) { return normalDensity(f, m) * m.z; }), 1, 2e-3) << alpha;
    }
  }
}

// Those that v sees cover it as seen from v, once: int G1 D max(0, v.m) dm = v.z [Heitz 2014 (14)].
TEST(Microfacets, VisibleOnesProjectToTheSurfaceSeen) {
  for (const MicrofacetKind kind : kKinds) {
    for (const float alpha : {0.1f, 0.4f, 1.f}) {
      for (const double cos_v : {0.1, 0.5, 1.0}) {
        const Microfacets f{kind, alpha};
        const Vec3 v = test::directionAt(cos_v, 1);
        const double seen = integrate([&](Vec3 m) { return normalDensity(f, m) * std::max(0.f, dot(v, m)); });
        EXPECT_NEAR(visibleFraction(f, v) * seen / cos_v, 1, 3e-3) << alpha << " from " << cos_v;
      }
    }
  }
}

TEST(Microfacets, ClosedValues) {
  const Vec3 up{0, 0, 1}, diagonal = test::directionAt(std::sqrt(0.5));
  for (const MicrofacetKind kind : kKinds) {
    EXPECT_NEAR(normalDensity({kind, 0.2f}, up), 1 / (std::numbers::pi * 0.04), 1e-4);
    EXPECT_EQ(visibleFraction({kind, 0.2f}, up), 1);
  }
  EXPECT_NEAR(visibleFraction({MicrofacetKind::kGgx, 1}, diagonal), 2 / (1 + std::sqrt(2)), 1e-6);
  // At alpha tan = 1: 2 / (1 + erf(1) + exp(-1) / sqrt(pi)).
  EXPECT_NEAR(visibleFraction({MicrofacetKind::kBeckmann, 1}, diagonal),
              2 / (1 + std::erf(1) + std::exp(-1) / std::sqrt(std::numbers::pi)), 1e-6);
}

}  // namespace
}  // namespace saccade
