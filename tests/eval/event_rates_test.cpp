#include "eval/metrics/event_rates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/hash_rng.h"
#include "eval/planes.h"

namespace saccade::eval {
namespace {

using test::plane;

constexpr double kC = 0.2;

// Counts the crossings of the grid of thresholds one after the other, without the code under test.
int crossings(double from, double change) {
  const double low = std::min(from, from + change), high = std::max(from, from + change);
  int count = 0;
  for (int k = -6; k <= 6; ++k) count += low < k * kC && k * kC <= high;
  return count;
}

struct Expected {
  double events = 0, pixels = 0;
};
Expected bruteForce(double d, double ref) {
  constexpr int kPhases = 100'000;
  Expected sum;
  for (int i = 0; i < kPhases; ++i) {
    const double U = (i + 0.5) / kPhases * kC;
    if (crossings(U, ref) > 0) continue;
    const int n = crossings(U, d);
    sum.events += n, sum.pixels += n > 0;
  }
  return {sum.events / kPhases, sum.pixels / kPhases};
}

TEST(IntegratedRates, EqualTheSumOverAllPhases) {
  const double changes[] = {-0.91, -0.4, -0.27, -0.13, -0.04, 0, 0.02, 0.09, 0.15, 0.2, 0.33, 0.75};
  for (double d : changes) {
    for (double ref : changes) {
      const EventRates rates =
          integratedRates(plane({static_cast<float>(d)}), plane({static_cast<float>(ref)}), kC);
      const Expected wrong = bruteForce(d, ref), missed = bruteForce(ref, d);
      SCOPED_TRACE(testing::Message() << d << " against " << ref);
      // A phase next to a threshold can fall on either side.
      EXPECT_NEAR(rates.false_events, wrong.events, 5e-5);
      EXPECT_NEAR(rates.false_pixels, wrong.pixels, 5e-5);
      EXPECT_NEAR(rates.missed_events, missed.events, 5e-5);
      EXPECT_NEAR(rates.missed_pixels, missed.pixels, 5e-5);
    }
  }
}

TEST(IntegratedRates, OfNoiseAloneAreItsSizeOverTheThreshold) {
  for (double d : {-1.0, -0.37, -0.01, 0.0, 0.05, 0.2, 0.61}) {
    EXPECT_NEAR(expectedFalseEvents(d, 0, kC), std::abs(d) / kC, 1e-12) << d;  // [E (31)]
  }
}

// By hand: 0.15 fires at U >= 0.05, and 0.05 fires at U >= 0.15. So 0.1 of 0.2 is false. -0.05 fires at U <
// 0.05.
TEST(IntegratedRates, AreMeansOverThePixels) {
  const EventRates rates =
      integratedRates(plane({0.15f, 0.15f, 0, 0.3f}), plane({0.05f, -0.05f, 0.1f, 0.3f}), kC);
  EXPECT_NEAR(rates.false_events, (0.5 + 0.75 + 0 + 0) / 4, 1e-6);
  EXPECT_NEAR(rates.missed_events, (0 + 0.25 + 0.5 + 0) / 4, 1e-6);
  EXPECT_NEAR(rates.false_pixels, rates.false_events, 1e-12);  // no pixel has two
}

TEST(IntegratedRates, DoNotHideNaN) {
  EXPECT_TRUE(std::isnan(integratedRates(plane({NAN}), plane({0.1f}), kC).false_events));
  EXPECT_TRUE(std::isnan(integratedRates(plane({0.1f}), plane({NAN}), kC).missed_events));
}

TEST(SampledRates, ConvergeToTheIntegratedOnes) {
  ImageF x(300, 200), ref(300, 200);
  for (int i = 0; i < 300 * 200; ++i) {
    const std::uint64_t pixel = static_cast<std::uint64_t>(i);
    ref.at(i % 300, i / 300) = toUnit(hashKey(1, pixel)) - 0.5f;
    x.at(i % 300, i / 300) = ref.at(i % 300, i / 300) + 0.4f * (toUnit(hashKey(2, pixel)) - 0.5f);
  }
  const EventRates all = integratedRates(x, ref, kC), some = sampledRates(x, ref, kC, 7);
  EXPECT_GT(all.false_events, 0.02);
  // 60000 pixels with at most one event of variance 1/4: five standard deviations are 0.01.
  EXPECT_NEAR(some.false_events, all.false_events, 0.01);
  EXPECT_NEAR(some.missed_events, all.missed_events, 0.01);
  EXPECT_NEAR(some.false_pixels, all.false_pixels, 0.01);
  EXPECT_NEAR(some.missed_pixels, all.missed_pixels, 0.01);
  EXPECT_EQ(some.false_events, sampledRates(x, ref, kC, 7).false_events);
  EXPECT_NE(some.false_events, sampledRates(x, ref, kC, 8).false_events);
}

// Both share the phase. A change that equals the reference has no false and no missed events, for any seed.
TEST(SampledRates, AreZeroForTheReferenceItself) {
  const ImageF dL = plane({-0.7f, -0.1f, 0, 0.05f, 0.19f, 0.4f});
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const EventRates rates = sampledRates(dL, dL, kC, seed);
    EXPECT_EQ(rates.false_events, 0);
    EXPECT_EQ(rates.missed_events, 0);
  }
}

// A change of 2 C crosses two thresholds from any phase. Nothing counts where the reference fires.
TEST(SampledRates, CountEveryThreshold) {
  const EventRates rates = sampledRates(plane({0.5f, -0.5f}), plane({0, 0.5f}), 0.25, 3);
  EXPECT_EQ(rates.false_events, 1);
  EXPECT_EQ(rates.false_pixels, 0.5);
  EXPECT_EQ(rates.missed_events, 0);
}

}  // namespace
}  // namespace saccade::eval
