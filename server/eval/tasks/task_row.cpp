#include "eval/tasks/task_row.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

// A number without a meaning is a dash.
std::string cellOf(double value, const char* pattern) {
  return std::isfinite(value) ? format(pattern, value) : "-";
}

std::string headingOf(const TaskRow& first, const std::vector<TaskRow>& rows) {
  std::string text = format("%s\n%-28s %9s %9s", first.view().c_str(), "", "CPU ms", "events");
  for (const TaskRow& row : rows)
    if (row.sameView(first) && sourceOf(row) == sourceOf(first)) text += format(" %15s", row.task->name);
  return text + '\n';
}

}  // namespace

std::string TaskRow::view() const {
  return noise == kNoNoise ? scene : scene + ", noise of " + noise;
}

double TaskRow::error() const {
  const std::vector<double> errors = errorsOf(*this);
  if (errors.empty()) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0;
  for (const double e : errors) sum += e;
  return sum / static_cast<double>(errors.size());
}

double TaskRow::standardError() const {
  const std::vector<double> errors = errorsOf(*this);
  if (errors.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  const double n = static_cast<double>(errors.size()), mean = error();
  double squares = 0;
  for (const double e : errors) squares += (e - mean) * (e - mean);
  return std::sqrt(squares / (n - 1) / n);
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
    const bool new_view = !prev || !row.sameView(*prev);
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

}  // namespace saccade::eval
