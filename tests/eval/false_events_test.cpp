#include "eval/figures/false_events.h"

#include <gtest/gtest.h>

#include <cmath>

#include "eval/changes.h"

namespace saccade::eval {
namespace {

constexpr double kBias = 1e-3, kC = 0.5;
constexpr int kSide = 64, kFrames = 10;

// Five sigma of the mean over all pixel-frames. Each has an event at the rate `rate` < 1.
double fiveSigma(double rate, double share = 1) {
  return 5 * std::sqrt(rate * (1 - rate) / (share * kSide * kSide * kFrames));
}

template <class Run, class Truth>
FalseEvents count(Run run, Truth truth) {
  const auto changes = test::frames(kFrames, kSide, kSide, kBias, run),
             ref = test::frames(kFrames, kSide, kSide, kBias, truth);
  return countFalseEvents(test::sequence(changes), test::sequence(ref), kBias, kC);
}

TEST(NoiseSize, LeavesOutliersOutOnce) {
  std::vector<float> noise;
  for (int i = 0; i < 500; ++i) noise.push_back(1), noise.push_back(-1);
  noise.push_back(1000);
  const NoiseSize size = noiseSize(noise);
  EXPECT_NEAR(size.mean_abs, 2000.0 / 1001, 1e-12);
  const double mean = 1000.0 / 1001;
  EXPECT_NEAR(size.sigma, std::sqrt((1000 + 1e6) / 1001 - mean * mean), 1e-9);
  EXPECT_NEAR(size.sigma_trimmed, 1, 1e-12);
}

// Noise of +0.1 and -0.1 in turn, on a truth that stands still.
TEST(FalseEvents, WithFreshPhasesAreMeanNoiseOverC) {
  const FalseEvents e =
      count([](int f, int, int) { return f % 2 ? 0.1 : -0.1; }, [](int, int, int) { return 0.004; });
  EXPECT_EQ(e.quiet.share, 1);
  EXPECT_NEAR(e.quiet.noise.mean_abs, 0.1, 1e-6);
  EXPECT_NEAR(e.quiet.noise.sigma, 0.1, 1e-6);
  EXPECT_NEAR(e.quiet.fresh_phase, 0.1 / kC, fiveSigma(0.1 / kC));
}

// An accumulating pixel fires once, if its first 0.1 crosses a threshold. Later changes are smaller than the
// C to the next one.
TEST(FalseEvents, OfAnAccumulatingSensorStopWhereNoiseOnlySwings) {
  const FalseEvents e =
      count([](int f, int, int) { return f % 2 ? 0.1 : -0.1; }, [](int, int, int) { return 0; });
  const double once = 0.1 / (2 * kC);
  EXPECT_NEAR(e.quiet.accumulating * kFrames, once, 5 * std::sqrt(once * (1 - once)) / kSide);
}

TEST(FalseEvents, CountAtRestOnlyWhereTheTruthIsQuiet) {
  const FalseEvents e = count([](int, int x, int) { return x == 0 ? 0.2 : 0.3; },
                              [](int, int x, int) { return x == 0 ? 0.0 : 0.3; });
  EXPECT_DOUBLE_EQ(e.quiet.share, 1.0 / kSide);
  EXPECT_NEAR(e.quiet.noise.mean_abs, 0.2, 1e-6);
  EXPECT_NEAR(e.quiet.fresh_phase, 0.2 / kC, fiveSigma(0.2 / kC, 1.0 / kSide));
  EXPECT_EQ(e.all.share, 1);
  EXPECT_NEAR(e.all.noise.mean_abs, 0.2 / kSide, 1e-6);
}

// The derivation in the header holds for changes of the same sign and of opposite signs.
TEST(FalseAndMissed, AreNoiseOverCBelowC) {
  for (const double truth : {0.25, -0.15, 0.05}) {
    const FalseEvents e = count([](int, int, int) { return 0.15; }, [&](int, int, int) { return truth; });
    const double expected = std::abs(0.15 - truth) / kC;
    EXPECT_EQ(e.small.share, 1);
    EXPECT_NEAR(e.small.false_and_missed, expected, fiveSigma(expected)) << truth;
    EXPECT_NEAR(e.all.false_and_missed, expected, fiveSigma(expected)) << truth;
  }
}

// With more than C the truth fires at every phase, so that no event is false.
TEST(FalseAndMissed, TellLargeChangesFromSmallOnes) {
  const auto half = [](int x, double large, double small) { return x % 2 ? large : small; };
  const FalseEvents e = count([&](int, int x, int) { return half(x, 0.9, 0.1); },
                              [&](int, int x, int) { return half(x, 0.6, 0.2); });
  EXPECT_EQ(e.small.share, 0.5);
  EXPECT_NEAR(e.small.noise.mean_abs, 0.1, 1e-6);
  EXPECT_NEAR(e.small.false_and_missed, 0.1 / kC, fiveSigma(0.1 / kC, 0.5));
  EXPECT_NEAR(e.all.false_and_missed, 0.5 * 0.1 / kC, fiveSigma(0.1 / kC));
}

}  // namespace
}  // namespace saccade::eval
