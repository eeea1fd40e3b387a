#include "eval/figures/time_chart.h"

#include "eval/pictures/svg_chart.h"

namespace saccade::eval {
namespace {

double wrongShare(const WindowErrors& errors) {
  return errors.false_share + errors.missed_share;
}

double timeError(const WindowErrors& errors) {
  return errors.time;
}

ChartPanel makePanel(const std::string& title, const char* label, const std::vector<TimeSeries>& series,
                     double (*error)(const WindowErrors&)) {
  ChartPanel panel{title, "CPU ms per window", label, {}, true};
  for (const TimeSeries& of : series) {
    ChartLine line{of.name, {}};
    for (const auto& [name, row] : of.rows)
      if (error(row.errors) > 0) line.points.push_back({row.cpu_ms, error(row.errors), name});
    panel.lines.push_back(std::move(line));
  }
  return panel;
}

}  // namespace

std::string drawTimeChart(const std::string& title, const std::vector<TimeSeries>& series) {
  return drawCharts({makePanel(title, "false and missed events, share of the true ones", series, wrongShare),
                     makePanel(title, "error of time, windows", series, timeError)},
                    2);
}

}  // namespace saccade::eval
