#include "eval/figures/odds_bins.h"

#include <gtest/gtest.h>

#include <cmath>

#include "eval/changes.h"

namespace saccade::eval {
namespace {

constexpr double kBias = 1e-3, kC = 0.1;
constexpr int kSide = 64;

// dL is 0.4 on the left, and -0.4 on the right; the true changes are 0.3 and 0.1. A quarter of the events is
// false on the left, and all on the right.
TEST(OddsBins, TellTheShareThatIsFalse) {
  auto run = test::frames(5, kSide, kSide, kBias, [](int, int x, int) { return x < 32 ? 0.4 : -0.4; });
  const auto truth = test::frames(5, kSide, kSide, kBias, [](int, int x, int) { return x < 32 ? 0.3 : 0.1; });
  for (IntensityChange& change : run) {
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        change.I_now.at(x, y) = change.I_prev.at(x, y) + change.dI.at(x, y);
        change.var_dI.at(x, y) = x < 32 ? 0.f : 1e6f;
      }
  }
  const OddsBins odds = binsOfOdds(test::sequence(run), test::sequence(truth), kBias, kC);
  // Those of the column beside the other half are not certain.
  EXPECT_NEAR(odds.bins.front().false_share, 0.25, 1e-4);
  EXPECT_EQ(odds.bins.front().odds, 0);
  EXPECT_NEAR(odds.bins.front().events, 5 * 31 * kSide * 0.4 / kC, 3 * kSide * 31);
  // Errors without bound, and a change as large as those around: artefact_odds.h gives Phi(1) + phi(1) -
  // phi(0).
  EXPECT_GT(odds.bins[6].false_share, 0.95);
  EXPECT_NEAR(odds.bins[6].odds, 0.684, 0.005);
  const OddsBin all = odds.mean();
  EXPECT_NEAR(all.events, 5 * kSide * kSide * 0.4 / kC, 0.04 * all.events);
  EXPECT_NEAR(all.false_share, 0.62, 0.02);
}

TEST(OddsBins, MeasureTheMeanDistance) {
  OddsBins odds;
  odds.bins[0] = {30, 0.05, 0.15};
  odds.bins[9] = {10, 0.95, 0.75};
  const OddsBin all = odds.mean();
  EXPECT_EQ(all.events, 40);
  EXPECT_NEAR(all.odds, 0.275, 1e-12);
  EXPECT_NEAR(all.false_share, 0.3, 1e-12);
  EXPECT_NEAR(odds.error(), (30 * 0.1 + 10 * 0.2) / 40, 1e-12);
  EXPECT_EQ(OddsBins{}.error(), 0);
}

}  // namespace
}  // namespace saccade::eval
