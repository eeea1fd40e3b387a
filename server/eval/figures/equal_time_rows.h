// Writes what `saccade-eval chart --budgets` measures.
#pragma once

#include <string>
#include <vector>

#include "eval/bench/equal_time.h"

namespace saccade::eval {

// CSV with a header: a row for each scene, method and budget, with all scores. `share` is the CPU time over
// the budget. A method that does not fit has 0 paths and no more.
std::string csvOf(const std::vector<EqualTimeRow>& rows);

// For stdout: a table for each scene and budget, sorted by false and missed events together.
std::string textOf(const std::vector<EqualTimeRow>& rows);

// For pages: Markdown with a line for each scene and a column for each budget. It names the method with the
// fewest false and missed events, its paths, and these events. The best other one follows it.
std::string markdownOf(const std::vector<EqualTimeRow>& rows);

// Prints both texts, and writes the CSV below a line with the settings. Throws std::runtime_error.
void writeEqualTimes(const std::vector<EqualTimeRow>& rows, const std::string& settings,
                     const std::string& path);

}  // namespace saccade::eval
