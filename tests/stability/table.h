// The results of the stability suite, as CSV and as Markdown.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "stability/cases.h"

namespace saccade::test {

inline const std::string kOurs = "event_svgf";

using MethodFigures = std::vector<std::pair<std::string, Figures>>;  // by method, ours among them

// The methods whose judged figure is below kClearly times ours.
inline constexpr double kClearly = 0.9;
std::vector<std::string> betterThanOurs(const StabilityCase& c, const MethodFigures& figures);

class StabilityTable {
 public:
  // `settings`: one line about all cases.
  explicit StabilityTable(std::string settings) : settings_(std::move(settings)) {}

  void add(const StabilityCase& c, MethodFigures figures) { rows_.push_back({c, std::move(figures)}); }

  std::string csv() const;       // a row for each case and method, all figures
  std::string markdown() const;  // a row for each case with its judged figure, then the reasons

 private:
  struct Row {
    StabilityCase of;
    MethodFigures figures;
  };
  std::string settings_;
  std::vector<Row> rows_;
};

}  // namespace saccade::test
