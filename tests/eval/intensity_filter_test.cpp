#include "eval/tasks/intensity_filter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "eval/changes.h"
#include "eval/planes.h"
#include "eval/task_truths.h"
#include "eval/tasks/correlation.h"
#include "eval/tasks/task.h"

namespace saccade::eval {
namespace {

constexpr double kAlpha = 5;

TEST(IntensityFilter, AddsEventsAndForgetsThem) {
  IntensityFilter filter(test::plane({0, 0}), 0, kAlpha);
  filter.add({100'000'000, 0, 0, 1}, 0.2);
  filter.add({200'000'000, 0, 0, 0}, 0.5);
  EXPECT_NEAR(filter.at(0, 0, 0.4), 0.2 * std::exp(-kAlpha * 0.3) - 0.5 * std::exp(-kAlpha * 0.2), 1e-6);
  EXPECT_EQ(filter.at(1, 0, 0.4), 0);
}

TEST(IntensityFilter, FollowsItsFrames) {
  IntensityFilter filter(test::plane({1, 2}), 0, kAlpha);
  EXPECT_NEAR(filter.at(1, 0, 0.7), 2, 1e-6);
  filter.setFrame(test::plane({3, 2}), 0.1);
  EXPECT_NEAR(filter.at(0, 0, 0.3), 3 - 2 * std::exp(-kAlpha * 0.2), 1e-6);
  filter.setFrame(test::plane({1, 2}), 0.3);
  EXPECT_NEAR(filter.at(0, 0, 0.3), 3 - 2 * std::exp(-kAlpha * 0.2), 1e-6);  // no jump
  EXPECT_NEAR(filter.at(0, 0, 9), 1, 1e-6);
}

TEST(Correlation, IsThatOfAnAffineFit) {
  EXPECT_NEAR(correlation(test::plane({1, 2, 4}), test::plane({5, 7, 11})), 1, 1e-9);
  EXPECT_NEAR(correlation(test::plane({1, 2, 4}), test::plane({-1, -2, -4})), -1, 1e-9);
  EXPECT_NEAR(correlation(test::plane({1, 0, -1, 0}), test::plane({0, 1, 0, -1})), 0, 1e-9);
  EXPECT_TRUE(std::isnan(correlation(test::plane({1, 1}), test::plane({0, 1}))));
}

// Each column changes at its own rate, from the same start. Events of a fine threshold tell it.
TEST(Intensity, IsScoredAgainstTheTruth) {
  constexpr int kWidth = 16, kHeight = 4, kFrames = 20;
  constexpr double kBias = 0.5, kThreshold = 0.002;
  const auto rise = [](int x) { return 0.005 * (x - 7); };
  const auto changes =
      test::frames(kFrames, kWidth, kHeight, kBias, [&](int, int x, int) { return rise(x); });
  TaskTruth truth = test::steadyTruth(kWidth, kHeight, kFrames, {});
  truth.L_start.fill(static_cast<float>(std::log(1 + kBias)));
  for (int f = 0; f < kFrames; ++f)
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        truth.frames[static_cast<std::size_t>(f)].L.at(x, y) =
            static_cast<float>(std::log(1 + kBias) + (f + 1) * rise(x));
  const ChangeSequence sequence = test::sequence(changes);
  const Events events = eventsOf(
      sequence,
      {.threshold = kThreshold, .threshold_off = kThreshold, .bias = kBias, .reconstruction = "direct"});
  const TaskInput input{events, sequence, kThreshold, kBias, truth};
  EXPECT_LT(scoreHighPass(input).error, 0.001);
  EXPECT_EQ(scoreHighPass(input).answers, std::size_t(kFrames));
  // The pictures of the changes stand still, so that its frames draw it back.
  EXPECT_LT(scoreComplementary(input).error, 0.01);
  EXPECT_TRUE(std::isnan(scoreHighPass({{}, sequence, kThreshold, kBias, truth}).error));
}

}  // namespace
}  // namespace saccade::eval
