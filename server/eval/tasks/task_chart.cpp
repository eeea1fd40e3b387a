#include "eval/tasks/task_chart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "eval/pictures/svg_chart.h"
#include "eval/pictures/text.h"

namespace saccade::eval {
namespace {

// A panel, and the row that began it.
struct TaskPanel {
  const TaskRow* first;
  ChartPanel chart;
};

ChartLine referenceLine(const TaskRow& reference, const std::vector<TaskRow>& rows) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const TaskRow& row : rows)
    if (!row.isReference()) least = std::min(least, row.cpu_ms), most = std::max(most, row.cpu_ms);
  return {kReferenceSource,
          {{least, reference.error(), ""}, {most, reference.error(), ""}},
          LineStyle::kReference};
}

// Adds a point to the line of its method, which lies behind those that are there.
void addPoint(const TaskRow& row, ChartPanel& panel) {
  auto line = std::find_if(panel.lines.begin(), panel.lines.end(),
                           [&](const ChartLine& l) { return l.name == row.method; });
  if (line == panel.lines.end()) line = panel.lines.insert(line, ChartLine{row.method, {}});
  const double error = row.standardError();
  line->points.push_back(
      {row.cpu_ms, row.error(), format("%d spp", row.spp), std::isfinite(error) ? error : 0});
}

// Adds the panel of the row's scene, noise and task if there is none.
ChartPanel& panelOf(const TaskRow& row, std::vector<TaskPanel>& panels) {
  auto panel = std::find_if(panels.begin(), panels.end(), [&](const TaskPanel& p) {
    return p.first->sameView(row) && p.first->task == row.task;
  });
  if (panel == panels.end()) {
    const ChartPanel empty{row.view() + ": " + row.task->name, "CPU ms per frame", row.task->error, {}};
    panel = panels.insert(panel, {&row, empty});
  }
  return panel->chart;
}

}  // namespace

std::string chartOf(const std::vector<TaskRow>& rows) {
  std::vector<TaskPanel> panels;
  for (const TaskRow& row : rows) {
    ChartPanel& panel = panelOf(row, panels);
    if (!std::isfinite(row.error())) continue;
    if (!(row.error() > 0)) panel.y_scale = Scale::kLinear;  // a logarithmic axis has no place for 0
    if (row.isReference())
      panel.lines.push_back(referenceLine(row, rows));
    else
      addPoint(row, panel);
  }
  std::vector<ChartPanel> charts;
  for (const TaskPanel& panel : panels) charts.push_back(panel.chart);
  const auto per_group = std::count_if(panels.begin(), panels.end(), [&](const TaskPanel& panel) {
    return panel.first->sameView(*panels.front().first);
  });
  return drawCharts(charts, static_cast<int>(per_group));
}

}  // namespace saccade::eval
