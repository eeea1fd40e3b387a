// The legend above charts: a colour for each name of a line.
#pragma once

#include <string>
#include <vector>

#include "eval/pictures/svg_chart.h"

namespace saccade::eval {

struct ChartKey {
  std::string name, color;
};

// In the order of first appearance; reference lines are black.
std::vector<ChartKey> keysOf(const std::vector<ChartPanel>& panels);
const std::string& colorOf(const std::vector<ChartKey>& keys, const std::string& name);

// Draws rows of at most `width` from `y` on, and sets `y` to the last row. Explains the Pareto front and
// error bars where the panels have them.
std::string drawLegend(const std::vector<ChartKey>& keys, const std::vector<ChartPanel>& panels, double left,
                       double width, double& y);

}  // namespace saccade::eval
