#include "eval/tasks/task_row.h"

#include <algorithm>
#include <cmath>

#include "eval/pictures/svg_chart.h"
#include "eval/pictures/text.h"

namespace saccade::eval {
namespace {

std::vector<double> errorsOf(const TaskRow& row) {
  std::vector<double> errors;
  for (const TaskScore& score : row.scores)
    if (std::isfinite(score.error)) errors.push_back(score.error);
  return errors;
}

std::string sourceOf(const TaskRow& row) {
  return format("%s@%d", row.method.c_str(), row.spp);
}

bool sameView(const TaskRow& a, const TaskRow& b) {
  return a.scene == b.scene && a.noise == b.noise;
}

std::string titleOf(const TaskRow& row) {
  return row.noise == kNoNoise ? row.scene : row.scene + ", noise of " + row.noise;
}

// A number without a meaning is a dash.
std::string cellOf(double value, const char* pattern) {
  return std::isfinite(value) ? format(pattern, value) : "-";
}

std::string headingOf(const TaskRow& first, const std::vector<TaskRow>& rows) {
  std::string text = format("%s\n%-28s %9s %9s", titleOf(first).c_str(), "", "CPU ms", "events");
  for (const TaskRow& row : rows)
    if (sameView(row, first) && sourceOf(row) == sourceOf(first)) text += format(" %15s", row.task->name);
  return text + '\n';
}

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

}  // namespace

double TaskRow::error() const {
  const std::vector<double> errors = errorsOf(*this);
  double sum = 0;
  for (const double e : errors) sum += e;
  return sum / static_cast<double>(errors.size());
}

double TaskRow::standardError() const {
  const std::vector<double> errors = errorsOf(*this);
  const double n = static_cast<double>(errors.size()), mean = error();
  double squares = 0;
  for (const double e : errors) squares += (e - mean) * (e - mean);
  return n < 2 ? std::numeric_limits<double>::quiet_NaN() : std::sqrt(squares / (n - 1) / n);
}

double TaskRow::answers() const {
  double sum = 0;
  for (const TaskScore& score : scores) sum += static_cast<double>(score.answers);
  return sum / static_cast<double>(scores.size());
}

std::string csvOf(const std::vector<TaskRow>& rows) {
  std::string csv = "scene,noise,task,method,spp,cpu_ms,events,error,standard_error,answers\n";
  for (const TaskRow& row : rows)
    csv += format("%s,%s,%s,%s,%d,%g,%g,%g,%g,%g\n", row.scene.c_str(), row.noise.c_str(), row.task->name,
                  row.method.c_str(), row.spp, row.cpu_ms, row.events, row.error(), row.standardError(),
                  row.answers());
  return csv;
}

std::string tableOf(const std::vector<TaskRow>& rows) {
  std::string text;
  const TaskRow* prev = nullptr;
  for (const TaskRow& row : rows) {
    const bool new_view = !prev || !sameView(row, *prev);
    if (new_view) text += (prev ? "\n\n" : "") + headingOf(row, rows);
    if (new_view || sourceOf(row) != sourceOf(*prev))
      text += (new_view ? "" : "\n") + format("%-28s %9s %9.4f", sourceOf(row).c_str(),
                                              row.isReference() ? "-" : format("%.2f", row.cpu_ms).c_str(),
                                              row.events);
    text += format(" %15s", cellOf(row.error(), "%.4f").c_str());
    prev = &row;
  }
  return text + '\n';
}

std::string chartOf(const std::vector<TaskRow>& rows) {
  std::vector<ChartPanel> panels;
  std::vector<const TaskRow*> firsts;  // of the panels
  for (const TaskRow& row : rows) {
    auto first = std::find_if(firsts.begin(), firsts.end(),
                              [&](const TaskRow* f) { return sameView(*f, row) && f->task == row.task; });
    if (first == firsts.end()) {
      first = firsts.insert(first, &row);
      panels.push_back({titleOf(row) + ": " + row.task->name, "CPU ms per frame", row.task->error, {}});
    }
    if (!std::isfinite(row.error())) continue;
    ChartPanel& panel = panels[static_cast<std::size_t>(first - firsts.begin())];
    if (!(row.error() > 0)) panel.y_scale = Scale::kLinear;  // a logarithmic axis has no place for 0
    if (row.isReference())
      panel.lines.push_back(referenceLine(row, rows));
    else
      addPoint(row, panel);
  }
  return drawCharts(panels,
                    static_cast<int>(std::count_if(firsts.begin(), firsts.end(), [&](const TaskRow* f) {
                      return sameView(*f, *firsts.front());
                    })));
}

}  // namespace saccade::eval
