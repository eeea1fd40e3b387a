// The results of the stability suite, as CSV and as Markdown.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "stability/comparison.h"

namespace saccade::test {

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
