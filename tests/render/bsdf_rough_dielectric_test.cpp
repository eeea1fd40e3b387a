// Rough glass over the whole sphere of directions.
#include <gtest/gtest.h>

#include "render/bsdf_cases.h"
#include "render/chi_square.h"

namespace saccade {
namespace {

constexpr double kPhi = 2 * std::numbers::pi;
using test::Histogram;

std::vector<test::BsdfCase> cases(const std::vector<float>& alphas) {
  std::vector<test::BsdfCase> all;
  for (const MicrofacetKind kind : {MicrofacetKind::kBeckmann, MicrofacetKind::kGgx})
    for (const float alpha : alphas) {
      const std::string name = (kind == MicrofacetKind::kGgx ? "ggx " : "beckmann ") + std::to_string(alpha);
      all.push_back({name, BsdfTables(test::roughModel(BsdfKind::kRoughDielectric, kind, alpha)), {}});
    }
  return all;
}

// The factor from radiance to power of light that goes through to wo.
float squaredIndex(const test::BsdfCase& c, Vec3 wo) {
  const float ior2 = c.tables.model.ior * c.tables.model.ior;
  return wo.z > 0 ? ior2 : 1 / ior2;
}

constexpr int kRings = 16, kSectors = 8, kSubRings = 48, kSubSectors = 48;  // over the sphere

std::size_t binOf(Vec3 w) {
  const double turn = std::atan2(w.y, w.x) / kPhi;
  const int ring = std::min(static_cast<int>((w.z + 1) / 2 * kRings), kRings - 1);
  return static_cast<std::size_t>(
      ring * kSectors + std::min(static_cast<int>((turn < 0 ? turn + 1 : turn) * kSectors), kSectors - 1));
}

TEST(RoughDielectric, SamplesFollowTheirPdf) {
  constexpr int kSamples = 40000, kCosines = kRings * kSubRings, kAzimuths = kSectors * kSubSectors;
  for (const test::BsdfCase& c : cases({0.2f, 0.5f, 1.f})) {
    for (const double cos_o : {0.3, 0.9, -0.3, -0.9}) {
      const Vec3 wo = test::directionAt(cos_o, 0.3);
      Histogram observed(kRings * kSectors + 1), expected(observed.size());
      for (std::uint64_t i = 0; i < kSamples; ++i) {
        const BsdfSample s = test::sampleAt(c.bsdf(), wo, i);
        ++observed[s.pdf > 0 ? binOf(s.wi) : observed.size() - 1];
      }
      double sum = 0;
      for (int i = 0; i < kCosines; ++i)
        for (int j = 0; j < kAzimuths; ++j) {
          const Vec3 wi = test::directionAt((i + 0.5) / kCosines * 2 - 1, (j + 0.5) / kAzimuths * kPhi);
          const double n = evaluateBsdf(c.bsdf(), wo, wi).pdf * 2 * kPhi / kCosines / kAzimuths * kSamples;
          expected[binOf(wi)] += n, sum += n;
        }
      expected.back() = kSamples - sum;
      EXPECT_LT(test::chiSquareScore(observed, expected), test::kScoreOf1In1000)
          << c.name << " from " << cos_o;
    }
  }
}

// Its tables, which come from microfacets alone, say how much it reflects and lets through. Only light
// between several microfacets is lost.
TEST(RoughDielectric, PowerIsKept) {
  for (const test::BsdfCase& c : cases({0.05f, 0.2f, 0.5f})) {
    for (const float cos_o : {0.2f, 0.6f, 1.f, -0.2f, -0.6f, -1.f}) {
      const Vec3 wo = test::directionAt(cos_o);
      double reflected = 0, through = 0;
      constexpr int kCount = 40000;
      for (std::uint64_t i = 0; i < kCount; ++i) {
        const BsdfSample s = test::sampleAt(c.bsdf(), wo, i);
        (s.transmitted ? through : reflected) +=
            s.weight.x * (s.transmitted ? squaredIndex(c, wo) : 1) / kCount;
      }
      const std::string what = c.name + " from " + std::to_string(cos_o);
      EXPECT_NEAR(bsdfAlbedo(c.bsdf(), cos_o).x, reflected + through, 0.015) << what;
      const Bsdf mirror{&c.tables, {}, {1, 1, 1}, {}};
      EXPECT_NEAR(bsdfAlbedo(mirror, cos_o).x, reflected, 0.015) << what;
      EXPECT_LE(reflected + through, 1.005) << what;
      EXPECT_GE(reflected + through, c.tables.model.alpha < 0.1f ? 0.95 : 0.6) << what;
    }
  }
}

// f(wo, wi) n(wi)^2 = f(wi, wo) n(wo)^2 [Walter 2007, 5.3], which radiance needs.
TEST(RoughDielectric, IsReciprocalButForTheSquaredIndex) {
  for (const test::BsdfCase& c : cases({0.2f, 0.6f})) {
    int compared = 0;
    for (std::uint64_t i = 0; i < 400; ++i) {
      const Vec3 wo = test::directionAt(2 * test::uniformAt(1, i) - 1);
      const Vec3 wi = test::directionAt(2 * test::uniformAt(2, i) - 1, 3 + 0.5 * test::uniformAt(3, i));
      if (std::abs(wo.z) < 0.05f || std::abs(wi.z) < 0.05f) continue;
      const double there = evaluateBsdf(c.bsdf(), wo, wi).value.y / std::abs(wi.z);
      const double back = evaluateBsdf(c.bsdf(), wi, wo).value.y / std::abs(wo.z);
      const double factor = wo.z * wi.z > 0 ? 1 : squaredIndex(c, wo);
      ASSERT_NEAR(there * factor, back, 2e-3 * back + 1e-6) << c.name << ' ' << i;
      compared += back > 1e-3 && wo.z * wi.z < 0;
    }
    EXPECT_GT(compared, 20);
  }
}

TEST(RoughDielectric, SamplesWeighValueOverPdf) {
  for (const test::BsdfCase& c : cases({0.1f, 0.5f})) {
    for (std::uint64_t i = 0; i < 300; ++i) {
      const Vec3 wo = test::directionAt(2 * test::uniformAt(4, i) - 1, 0.3);
      const BsdfSample s = test::sampleAt(c.bsdf(), wo, i);
      const BsdfValue v = evaluateBsdf(c.bsdf(), wo, s.wi);
      if (s.pdf == 0) continue;
      EXPECT_FALSE(s.delta);
      EXPECT_EQ(s.transmitted, s.wi.z * wo.z < 0);
      ASSERT_FLOAT_EQ(s.pdf, v.pdf) << c.name;
      ASSERT_NEAR(s.weight.y * s.pdf, v.value.y, 1e-5f * v.value.y) << c.name;
    }
  }
}

// Almost without roughness it bends light as smooth glass does.
TEST(RoughDielectric, TendsToSmoothGlass) {
  const BsdfTables smooth(test::modelOf(BsdfKind::kDielectric));
  for (const test::BsdfCase& c : cases({1e-3f})) {
    for (const float cos_o : {0.9f, 0.5f, -0.9f}) {
      const Vec3 wo = test::directionAt(cos_o);
      const BsdfSample bent = sampleBsdf({&smooth}, wo, 0.999f, 0.5f, 0.5f);
      const BsdfSample rough = sampleBsdf(c.bsdf(), wo, 0.999f, 0.5f, 0.5f);
      EXPECT_TRUE(rough.transmitted);
      EXPECT_NEAR(length(rough.wi - bent.wi), 0, 0.01) << c.name << cos_o;
      EXPECT_NEAR(rough.weight.x, bent.weight.x, 0.02 * bent.weight.x) << c.name << cos_o;
      EXPECT_NEAR(bsdfAlbedo(c.bsdf(), cos_o).x, 1, 2e-3) << c.name << cos_o;
    }
  }
}

TEST(RoughDielectric, DegenerateInputIsFinite) {
  constexpr float kCosines[] = {-1, -0.5f, -1e-4f, -1e-8f, 0, 1e-8f, 1e-4f, 0.5f, 1};
  constexpr float kNumbers[] = {0, 0.3f, 1 - 0x1p-24f};
  for (const test::BsdfCase& c : cases({0.f, 1e-3f, 1.f})) {
    for (const float cos_o : kCosines) {
      const Vec3 wo = test::directionAt(cos_o);
      for (const float cos_i : kCosines) {
        const BsdfValue v = evaluateBsdf(c.bsdf(), wo, test::directionAt(cos_i, 3.14159265f));
        ASSERT_TRUE(std::isfinite(v.value.x) && std::isfinite(v.pdf))
            << c.name << ' ' << cos_o << ' ' << cos_i;
      }
      for (const float u_lobe : kNumbers)
        for (const float u1 : kNumbers)
          for (const float u2 : kNumbers) {
            const BsdfSample s = sampleBsdf(c.bsdf(), wo, u_lobe, u1, u2);
            ASSERT_TRUE(std::isfinite(s.weight.x) && std::isfinite(s.pdf)) << c.name << ' ' << cos_o;
            ASSERT_NEAR(length(s.wi), 1, 1e-4) << c.name << ' ' << cos_o;
          }
    }
  }
}

}  // namespace
}  // namespace saccade
