// Writes the tables of `saccade-eval cells`.
#pragma once

#include <string>
#include <vector>

#include "eval/bench/ratios.h"

namespace saccade::eval {

// CSV with a header. It has a row for each cell, candidate and column of kComparedColumns. The shares of dI
// and dL that arrive have rows without a baseline. A cell that is left out has one row, with the reason as
// its mark.
std::string csvOf(const std::vector<ComparedCell>& cells);

// For stdout: the figures of one cell, and below each candidate its ratios.
std::string textOf(const ComparedCell& cell);
// For stdout: geometric means and largest ratios of each candidate. `candidates` are their names.
std::string summaryText(const std::vector<ComparedCell>& cells, const std::vector<std::string>& candidates);

}  // namespace saccade::eval
