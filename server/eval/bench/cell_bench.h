// Measures the cells of `saccade-eval cells`, one after the other.
#pragma once

#include <memory>

#include "eval/bench/ratios.h"

namespace saccade::eval {

class CellBench {
 public:
  // Keeps what is measured in the table `results`. Throws std::runtime_error, also for a table of other
  // settings.
  CellBench(const BenchOptions& o, std::vector<Setting> baselines, std::vector<Setting> candidates,
            const std::string& results);

  // Whether the table has all rows of a cell.
  bool isComplete(const Cell& cell) const;

  // Measures what the table lacks, with progress on stderr. A complete cell is not rendered again. Throws
  // SceneError, Interrupted.
  ComparedCell compare(const Cell& cell);

 private:
  const Result* find(const Cell& cell, const Setting& s) const;
  std::string fill(const Cell& cell);

  const BenchOptions o_;
  const std::vector<Setting> baselines_, candidates_;
  ResultTable table_;
  TilePool pool_;
  std::string scene_name_;
  std::shared_ptr<const RenderScene> scene_;  // of that name
};

}  // namespace saccade::eval
