// Compares methods at equal CPU time: `saccade-eval chart --budgets 1,4,16`.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "eval/bench/results.h"

namespace saccade::eval {

// Finds the most paths per pixel that take at most `budget_ms` of CPU time a frame, among multiples of
// `step`. 0: even `step` paths take longer. `time_of` measures a number of paths, kTries times at most.
// `known` holds what is measured already, and takes what is measured. Any number whose time is within kClose
// of the budget will do.
using MeasureTime = std::function<double(int spp)>;
int pathsWithin(double budget_ms, int step, std::map<int, double>& known, const MeasureTime& time_of);
inline constexpr int kTries = 6;
inline constexpr double kClose = 0.93;

// A budget of 1 is the time of the default method at so many paths.
inline constexpr int kBudgetPaths = 2;

struct EqualTimeRow {
  std::string scene, method;
  double budget;
  double budget_ms;  // CPU ms per frame
  Result result;     // spp = 0: nothing fits, and no other member is set
};

// For each method and budget, the row of the most paths that fit. Rows that `table` lacks are measured and
// added to it. Throws Interrupted.
std::vector<EqualTimeRow> measureEqualTimes(const Bench& bench, const std::string& scene,
                                            const std::vector<std::string>& methods,
                                            const std::vector<double>& budgets, const BenchOptions& o,
                                            ResultTable& table, const TimeBench& times);

}  // namespace saccade::eval
