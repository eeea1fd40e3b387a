#include "eval/metrics/timed_events.h"

#include <gtest/gtest.h>

#include <cmath>

namespace saccade::eval {
namespace {

// A ramp fires one event per threshold, whatever the pieces that it comes in.
TEST(LineSensor, FiresWhereARampPassesThresholds) {
  constexpr double kC = 0.2, kSlope = 0.37;
  LineSensor whole(8, kC), cut(8, kC);
  for (std::uint32_t pixel = 0; pixel < 8; ++pixel) {
    whole.move(pixel, 0, 10, 10 * kSlope);
    for (int t = 0; t < 10; ++t) cut.move(pixel, t, t + 1, kSlope);
  }
  const auto events = whole.events(), same = cut.events();
  ASSERT_EQ(events.size(), same.size());
  EXPECT_NEAR(static_cast<double>(events.size()), 8 * 10 * kSlope / kC, 8);
  for (std::size_t i = 0; i < events.size(); ++i) {
    EXPECT_NEAR(events[i].time, same[i].time, 1e-9);
    EXPECT_TRUE(events[i].on);
    if (i > 0 && events[i].pixel == events[i - 1].pixel) {
      EXPECT_NEAR(events[i].time - events[i - 1].time, kC / kSlope, 1e-9);
    }
  }
}

TEST(LineSensor, TurnsBackAtAnyLevel) {
  LineSensor sensor(1, 1);
  double L = 0;
  for (const double to : {2.5, -0.5, 0.3, 4.}) sensor.move(0, L, L + 1, to - L), L = to;
  int sum = 0;
  for (const TimedEvent& e : sensor.events()) sum += e.on ? 1 : -1;
  EXPECT_NEAR(sum, 4, 1);
}

TEST(TimedScore, CountsByPixelPolarityAndWindow) {
  const std::vector<TimedEvent> truth{{0, 1, true}, {0, 3, true}, {0, 18, false}, {5, 2, true}};
  EXPECT_EQ(scoreEvents(truth, truth, 16).false_events + scoreEvents(truth, truth, 16).missed, 0);
  EXPECT_EQ(scoreEvents(truth, truth, 16).time_error, 0);
  // One event less, one of another pixel, and one that is late by 0.5.
  const std::vector<TimedEvent> events{{0, 1.5, true}, {0, 3, true}, {5, 2, true}, {7, 4, false}};
  const TimedScore score = scoreEvents(events, truth, 16);
  EXPECT_EQ(score.missed, 0.25);
  EXPECT_EQ(score.false_events, 0.25);
  EXPECT_NEAR(score.time_error, 0.5 / 3, 1e-12);
}

}  // namespace
}  // namespace saccade::eval
