#include "eval/svg_chart.h"

#include <gtest/gtest.h>

namespace saccade {
namespace {

TEST(ParetoFront, KeepsWhatNothingBeats) {
  const ChartPanel panel{
      "", "", "", {{"a", {{1, 9, ""}, {4, 3, ""}, {8, 3, ""}}}, {"b", {{2, 9, ""}, {3, 5, ""}, {9, 1, ""}}}}};
  const auto front = paretoFront(panel);
  ASSERT_EQ(front.size(), 4u);
  const double x[] = {1, 3, 4, 9}, y[] = {9, 5, 3, 1};
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(front[i].x == x[i] && front[i].y == y[i]) << i;
}

TEST(DrawCharts, NamesEverythingAndEscapesIt) {
  const ChartPanel panel{"a < b", "time", "error", {{"one", {{1, 2, "2 spp"}, {10, 0.2, "8 spp"}}}}};
  const std::string svg = drawCharts({panel, panel}, 2);
  for (const char* text : {"a &lt; b", "time", "error", "one", "2 spp", "8 spp", "Pareto front", "</svg>"}) {
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  }
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(DrawCharts, LivesWithASinglePoint) {
  const std::string svg = drawCharts({{"", "", "", {{"one", {{3, 3, ""}}}}}}, 1);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

}  // namespace
}  // namespace saccade
