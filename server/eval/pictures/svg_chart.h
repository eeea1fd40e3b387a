// Charts as SVG text: one panel for each scene and metric, a line for each method.
#pragma once

#include <string>
#include <vector>

#include "eval/pictures/chart_axis.h"

namespace saccade::eval {

struct ChartPoint {
  double x, y;        // > 0 on a logarithmic axis
  std::string label;  // its settings: written beside the point where there is room, and shown by its tip
};

// kReference: a black line, what the others are measured against.
enum class LineStyle { kLineAndMarks, kLine, kMarks, kReference };

struct ChartLine {
  std::string name;
  std::vector<ChartPoint> points;  // joined in this order
  LineStyle style = LineStyle::kLineAndMarks;
};

struct ChartPanel {
  std::string title, x_label, y_label;
  std::vector<ChartLine> lines;  // the first lies on top
  bool pareto = false;           // draw the front of the points that no other beats, as a broad grey line
  Scale x_scale = Scale::kLog, y_scale = Scale::kLog;
};

// The points that no other point beats in both coordinates (smaller is better), by rising x.
std::vector<ChartPoint> paretoFront(const ChartPanel& panel);

// `across` panels in a row; a legend below.
std::string drawCharts(const std::vector<ChartPanel>& panels, int across);

}  // namespace saccade::eval
