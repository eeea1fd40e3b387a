#include "eval/pictures/svg_chart.h"

#include <gtest/gtest.h>

namespace saccade::eval {
namespace {

TEST(ParetoFront, KeepsWhatNothingBeats) {
  const ChartPanel panel{
      "", "", "", {{"a", {{1, 9, ""}, {4, 3, ""}, {8, 3, ""}}}, {"b", {{2, 9, ""}, {3, 5, ""}, {9, 1, ""}}}}};
  const auto front = paretoFront(panel);
  ASSERT_EQ(front.size(), 4u);
  const double x[] = {1, 3, 4, 9}, y[] = {9, 5, 3, 1};
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(front[i].x == x[i] && front[i].y == y[i]) << i;
}

TEST(ParetoFront, LeavesOutTheReference) {
  const ChartPanel panel{"", "", "", {{"a", {{2, 2, ""}}}, {"truth", {{1, 1, ""}}, LineStyle::kReference}}};
  ASSERT_EQ(paretoFront(panel).size(), 1u);
  EXPECT_EQ(paretoFront(panel)[0].x, 2);
}

TEST(DrawCharts, NamesEverythingAndEscapesIt) {
  ChartPanel panel{"a < b", "time", "error", {{"one", {{1, 2, "2 spp"}, {10, 0.2, "8 spp"}}}}};
  panel.pareto = true;
  const std::string svg = drawCharts({panel, panel}, 2);
  for (const char* text : {"a &lt; b", "time", "error", "one", "2 spp", "8 spp", "Pareto front", "</svg>"}) {
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  }
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(DrawCharts, APanelWithoutPointsSaysSo) {
  const ChartPanel empty{"a", "", "", {{"one", {}}}}, full{"b", "", "", {{"one", {{1, 2, ""}}}}};
  EXPECT_EQ(drawCharts({full}, 1).find("not measured here"), std::string::npos);
  EXPECT_NE(drawCharts({full, empty}, 2).find("not measured here"), std::string::npos);
}

int countOf(const std::string& text, const std::string& part) {
  int count = 0;
  for (auto at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

// Two points for each name. The legend marks both names.
TEST(DrawCharts, MarksPointsAndDrawsLinesByStyle) {
  const std::vector<ChartPoint> points{{1, 1, ""}, {2, 3, ""}};
  const struct {
    LineStyle style;
    int marks, lines;
  } cases[] = {{LineStyle::kLineAndMarks, 2, 1},
               {LineStyle::kLine, 0, 1},
               {LineStyle::kMarks, 2, 0},
               {LineStyle::kReference, 0, 1}};
  for (const auto& [style, marks, lines] : cases) {
    const std::string svg = drawCharts({{"", "", "", {{"one", points, style}}}}, 1);
    EXPECT_EQ(countOf(svg, "r=\"3\""), marks);
    EXPECT_EQ(countOf(svg, "<polyline"), lines);
    EXPECT_EQ(countOf(svg, "#000000") > 0, style == LineStyle::kReference);
  }
}

// A point has four places for labels. Of five points at one place, the last has only its tooltip.
TEST(DrawCharts, WritesNoLabelOverAnother) {
  ChartPanel panel{"", "", "", {}};
  for (int i = 1; i <= 5; ++i)
    panel.lines.push_back({"line " + std::to_string(i), {{1, 1, std::to_string(i) + " spp"}}});
  const std::string svg = drawCharts({panel}, 1);
  for (int i = 1; i <= 4; ++i) EXPECT_EQ(countOf(svg, ">" + std::to_string(i) + " spp<"), 1) << i;
  EXPECT_EQ(countOf(svg, ">5 spp<"), 0);
  EXPECT_EQ(countOf(svg, ">line 5 5 spp<"), 1);
}

// An error bar as long as the value reaches the bottom of a logarithmic axis.
TEST(DrawCharts, DrawsErrorBarsAndSaysWhatTheyAre) {
  const ChartPanel plain{"", "", "", {{"one", {{1, 1, ""}, {2, 4, ""}}}}};
  EXPECT_EQ(drawCharts({plain}, 1).find("standard error"), std::string::npos);
  ChartPanel panel = plain;
  panel.lines[0].points[1].error = 4;
  const std::string svg = drawCharts({panel}, 1);
  EXPECT_EQ(countOf(svg, "standard error over seeds"), 1);
  EXPECT_NE(svg.find("y2=\"276.0\" stroke=\"#d55e00\""), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

// Panels of 450x320: the six panels of a group make two rows of three. The next group begins a new row.
TEST(DrawCharts, WrapsPanelsAndBeginsARowForEachGroup) {
  const ChartPanel panel{"", "", "", {{"one", {{1, 1, ""}}}}};
  const auto sizeOf = [&](std::size_t panels, int per_group) {
    const std::string svg = drawCharts(std::vector<ChartPanel>(panels, panel), per_group);
    const double legend = 24;
    return std::pair(std::stod(svg.substr(svg.find("width=\"") + 7)) / 450,
                     (std::stod(svg.substr(svg.find("height=\"") + 8)) - legend) / 320);
  };
  EXPECT_EQ(sizeOf(6, 6), std::pair(3.0, 2.0));
  EXPECT_EQ(sizeOf(12, 6), std::pair(3.0, 4.0));
  EXPECT_EQ(sizeOf(4, 4), std::pair(2.0, 2.0));
  EXPECT_EQ(sizeOf(4, 2), std::pair(2.0, 2.0));
  EXPECT_EQ(sizeOf(1, 6), std::pair(1.0, 1.0));
}

// Two of these names fill a row.
TEST(DrawCharts, BreaksALegendThatIsTooWide) {
  const auto height = [](int names) {
    ChartPanel panel{"", "", "", {}};
    for (int i = 0; i < names; ++i)
      panel.lines.push_back({"a name of many letters " + std::to_string(i), {{1, 1, ""}}});
    const std::string svg = drawCharts({panel}, 1);
    return std::stod(svg.substr(svg.find("height=\"") + 8));
  };
  EXPECT_EQ(height(1), height(2));
  EXPECT_GT(height(8), height(4));
  EXPECT_GT(height(4), height(1));
}

// On a linear axis the middle of 1 and 3 is 2. The axis can go below zero.
TEST(DrawCharts, TakesLinearAxes) {
  ChartPanel panel{"", "", "", {{"one", {{1, -2, ""}, {2, 0, ""}, {3, 2, ""}}, LineStyle::kMarks}}};
  panel.x_scale = panel.y_scale = Scale::kLinear;
  const std::string svg = drawCharts({panel}, 1);
  EXPECT_NE(svg.find("cx=\"235.0\" cy=\"153.0\""), std::string::npos);  // the middle of the frame
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(DrawCharts, LivesWithASinglePoint) {
  const std::string svg = drawCharts({{"", "", "", {{"one", {{3, 3, ""}}}}}}, 1);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

}  // namespace
}  // namespace saccade::eval
