// Draws charts as SVG text: panels of lines.
#pragma once

#include <string>
#include <vector>

#include "eval/pictures/chart_axis.h"

namespace saccade::eval {

struct ChartPoint {
  double x, y;        // > 0 on a logarithmic axis
  std::string label;  // its settings: written beside the point where there is room, and in its tooltip
  double error = 0;   // > 0: half the length of an error bar along y
};

// kReference: a black line that others are compared with. It is not part of the Pareto front.
enum class LineStyle { kLineAndMarks, kLine, kMarks, kReference };

struct ChartLine {
  std::string name;
  std::vector<ChartPoint> points;  // joined in this order
  LineStyle style = LineStyle::kLineAndMarks;
};

struct ChartPanel {
  std::string title, x_label, y_label;
  std::vector<ChartLine> lines;  // the first lies on top
  bool pareto = false;           // draws the Pareto front as a broad grey line
  Scale x_scale = Scale::kLog, y_scale = Scale::kLog;
};

// The points that no other point beats in both coordinates (smaller is better), by rising x.
std::vector<ChartPoint> paretoFront(const ChartPanel& panel);

// Draws a legend and below it groups of `per_group` panels, at most three in a row. Each group begins a new
// row. A panel without points says that nothing is measured.
std::string drawCharts(const std::vector<ChartPanel>& panels, int per_group);

}  // namespace saccade::eval
