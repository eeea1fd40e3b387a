#include "app/sequence/sensor_schedule.h"

#include <gtest/gtest.h>

namespace saccade {
namespace {

SensorChange at(std::int64_t ms, double threshold) {
  return {.time = std::chrono::milliseconds(ms), .threshold = threshold};
}

// Each may cost a walk through all pixels.
TEST(SensorSchedule, ChangesOfOneIntervalAreOne) {
  std::vector<SensorChange> changes;
  for (int i = 1; i <= 1000; ++i) changes.push_back(at(10, i));
  changes.back().bias = 0.5;
  changes.push_back(at(10, 7));
  SensorSchedule schedule(changes);
  const auto ms = [](int t) { return TimeNs(std::chrono::milliseconds(t)); };
  EXPECT_FALSE(schedule.takeDue(ms(5), ms(10)));
  const auto due = schedule.takeDue(ms(10), ms(15));
  ASSERT_TRUE(due);
  EXPECT_EQ(due->threshold, 7);
  EXPECT_EQ(due->bias, 0.5);
  EXPECT_FALSE(due->threshold_off);
  EXPECT_FALSE(schedule.takeDue(ms(15), ms(20)));
  EXPECT_EQ(schedule.size(), changes.size());
}

}  // namespace
}  // namespace saccade
