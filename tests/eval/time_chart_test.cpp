#include "eval/figures/time_chart.h"

#include <gtest/gtest.h>

#include <cmath>

namespace saccade::eval {
namespace {

TimeTruthRow row(double cpu_ms, double missed, double time) {
  return {.cpu_ms = cpu_ms, .errors = {.missed_share = missed, .time = time}};
}

TEST(TimeChart, HasAPointForEachErrorThatThereIs) {
  const std::string svg = drawTimeChart(
      "a box", {{"whole frames", {{"2 frames", row(3, 0.1, 0.2)}, {"4 frames", row(6, 0, NAN)}}},
                {"refined", {{"refined ones", row(4, 0.01, 0.02)}}}});
  for (const char* text : {"a box", "whole frames", "2 frames", "refined ones", "CPU ms", "error of time"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  EXPECT_EQ(svg.find("4 frames"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace saccade::eval
