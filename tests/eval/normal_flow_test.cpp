#include "eval/tasks/normal_flow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "eval/task_truths.h"
#include "eval/tasks/task.h"

namespace saccade::eval {
namespace {

constexpr int kSize = 24, kMiddle = 12;
constexpr double kSpeed = 200;  // pixels per second

Image<double> noEvents() {
  Image<double> times(kSize, kSize);
  times.fill(-std::numeric_limits<double>::infinity());
  return times;
}

// A straight edge that moves at this angle, and has just come to the middle: t = distance / speed.
Image<double> edge(double angle) {
  Image<double> times = noEvents();
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const double t = ((x - kMiddle) * std::cos(angle) + (y - kMiddle) * std::sin(angle)) / kSpeed;
      if (t <= 0) times.at(x, y) = 1 + t;
    }
  }
  return times;
}

void expectFlow(const Image<double>& times, double angle) {
  const auto flow = normalFlow(times, kMiddle, kMiddle);
  ASSERT_TRUE(flow);
  EXPECT_NEAR(flow->x, kSpeed * std::cos(angle), 1e-3 * kSpeed);
  EXPECT_NEAR(flow->y, kSpeed * std::sin(angle), 1e-3 * kSpeed);
}

TEST(NormalFlow, IsThatOfAnEdge) {
  for (const double angle : {0.0, 0.4, 1.1, 2.5, -1.9}) expectFlow(edge(angle), angle);
}

TEST(NormalFlow, LeavesOutEventsOfAnotherEdge) {
  Image<double> times = edge(0.4);
  times.at(kMiddle - 1, kMiddle - 2) -= 0.04;
  times.at(kMiddle - 2, kMiddle + 1) -= 0.03;
  expectFlow(times, 0.4);
}

TEST(NormalFlow, NeedsNeighbours) {
  Image<double> times = noEvents();
  times.at(kMiddle, kMiddle) = 1;
  EXPECT_FALSE(normalFlow(times, kMiddle, kMiddle));
  for (int y = 0; y < kSize; ++y) times.at(kMiddle, y) = 1 - 0.001 * (kMiddle - y);  // a line is no plane
  EXPECT_FALSE(normalFlow(times, kMiddle, kMiddle));
}

// A vertical edge that moves to the right makes an event in each pixel. The truth also moves down by the same
// speed, which nobody can see across the edge.
TEST(NormalFlow, IsScoredAcrossTheEdge) {
  Events events;
  for (std::uint16_t x = 0; x < kSize; ++x)
    for (std::uint16_t y = 0; y < kSize; ++y)
      events.push_back({static_cast<std::int64_t>(1e9 * x / kSpeed), x, y, 1});
  const TaskTruth truth = test::steadyTruth(kSize, kSize, 40, {float(kSpeed), float(kSpeed)});
  const TaskScore score = scoreNormalFlow({events, {}, 0.2, 1e-3, truth});
  EXPECT_NEAR(score.error, 0, 1e-3);
  EXPECT_GT(score.answers, 400u);
  const TaskTruth twice = test::steadyTruth(kSize, kSize, 40, {float(2 * kSpeed), 0});
  EXPECT_NEAR(scoreNormalFlow({events, {}, 0.2, 1e-3, twice}).error, 0.5, 1e-3);
  EXPECT_TRUE(std::isnan(scoreNormalFlow({{}, {}, 0.2, 1e-3, truth}).error));
}

}  // namespace
}  // namespace saccade::eval
