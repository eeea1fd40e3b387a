// Samples against the densities that are claimed for them.
#include <gtest/gtest.h>

#include "render/bsdf_cases.h"
#include "render/chi_square.h"

namespace saccade {
namespace {

constexpr int kRings = 12, kSectors = 12;  // bins over the upper hemisphere, of equal solid angle
constexpr int kSubRings = 16, kSubSectors = 48;
constexpr int kSamples = 40000;
constexpr double kPhi = 2 * std::numbers::pi;
using test::Histogram;

// The last entry: delta, or no direction at all.
Histogram observed(const Bsdf& b, Vec3 wo) {
  Histogram counts(kRings * kSectors + 1);
  for (std::uint64_t i = 0; i < kSamples; ++i) {
    const BsdfSample s = test::sampleAt(b, wo, i);
    const double turn = std::atan2(s.wi.y, s.wi.x) / kPhi;
    const int ring = std::min(static_cast<int>(s.wi.z * kRings), kRings - 1);
    const int sector = std::min(static_cast<int>((turn < 0 ? turn + 1 : turn) * kSectors), kSectors - 1);
    ++counts[s.pdf > 0 && !s.delta ? static_cast<std::size_t>(ring * kSectors + sector) : counts.size() - 1];
  }
  return counts;
}

Histogram expected(const Bsdf& b, Vec3 wo) {
  Histogram counts(kRings * kSectors + 1);
  constexpr int kCosines = kRings * kSubRings, kAzimuths = kSectors * kSubSectors;
  double sum = 0;
  for (int i = 0; i < kCosines; ++i) {
    for (int j = 0; j < kAzimuths; ++j) {
      const Vec3 wi = test::directionAt((i + 0.5) / kCosines, (j + 0.5) / kAzimuths * kPhi);
      const double n = evaluateBsdf(b, wo, wi).pdf * kPhi / kCosines / kAzimuths * kSamples;
      counts[static_cast<std::size_t>(i / kSubRings * kSectors + j / kSubSectors)] += n, sum += n;
    }
  }
  counts.back() = kSamples - sum;
  return counts;
}

std::vector<test::BsdfCase> cases() {
  std::vector<test::BsdfCase> all = test::roughCases({0.1f, 0.4f, 1.f});
  for (test::BsdfCase& c : test::smoothCases()) all.push_back(std::move(c));
  for (test::BsdfCase& c : test::metallicRoughnessCases({0.3f, 0.6f, 1.f})) all.push_back(std::move(c));
  for (test::BsdfCase& c : test::glossCases({0.1f, 0.4f, 1.f})) all.push_back(std::move(c));
  for (test::BsdfCase& c : test::coatedCases({0.1f, 0.4f, 1.f})) all.push_back(std::move(c));
  return all;
}

TEST(Samples, FollowTheirPdf) {
  for (const test::BsdfCase& c : cases()) {
    for (const double cos_o : {0.2, 0.6, 0.95}) {
      const Vec3 wo = test::directionAt(cos_o, 0.3);
      EXPECT_LT(test::chiSquareScore(observed(c.bsdf(), wo), expected(c.bsdf(), wo)), test::kScoreOf1In1000)
          << c.name << " from " << cos_o;
    }
  }
}

TEST(Samples, WeighValueOverPdf) {
  for (const test::BsdfCase& c : cases()) {
    for (std::uint64_t i = 0; i < 300; ++i) {
      const Vec3 wo = test::directionAt(test::uniformAt(4, i), 0.3);
      const BsdfSample s = test::sampleAt(c.bsdf(), wo, i);
      const BsdfValue v = evaluateBsdf(c.bsdf(), wo, s.wi);
      if (s.delta) {
        ASSERT_TRUE(s.pdf > 0 && s.pdf <= 1) << c.name;
      } else {
        ASSERT_NEAR(s.pdf, v.pdf, 1e-6f * v.pdf) << c.name;
        ASSERT_NEAR(s.weight.y * s.pdf, v.value.y, 1e-5f * v.value.y) << c.name;
      }
    }
  }
}

}  // namespace
}  // namespace saccade
