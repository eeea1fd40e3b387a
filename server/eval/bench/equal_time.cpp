#include "eval/bench/equal_time.h"

#include <algorithm>
#include <cmath>

#include "saccade/wire/ranges.h"

namespace saccade::eval {
namespace {

using Times = std::map<int, double>;

// The largest number of paths within the budget; end(): none.
Times::const_iterator mostWithin(const Times& known, double budget_ms) {
  const auto fits = [&](const auto& at) { return at.second <= budget_ms; };
  const auto most = std::find_if(known.rbegin(), known.rend(), fits);
  return most == known.rend() ? known.end() : std::prev(most.base());
}

// Where a line through two points reaches the budget. Time is nearly linear in the number of paths.
double reaches(double budget_ms, Times::const_reference a, Times::const_reference b) {
  const double slope = (b.second - a.second) / (b.first - a.first);
  return slope > 0 ? a.first + (budget_ms - a.second) / slope : 2.0 * b.first;
}

// The number of paths to measure next: above `low`, and below the next known one.
int nextGuess(double budget_ms, int step, const Times& known, Times::const_iterator low) {
  const auto high = std::next(low);
  double guess = 0, most = std::min(8.0 * low->first, static_cast<double>(ranges::kSpp.max));
  if (high != known.end()) {
    guess = reaches(budget_ms, *low, *high), most = high->first - step;
  } else if (low != known.begin()) {
    guess = reaches(budget_ms, *std::prev(low), *low);
  } else {
    guess = reaches(budget_ms, {0, 0.0}, *low);
  }
  return std::max(static_cast<int>(std::clamp(guess, 0.0, most)) / step * step, low->first + step);
}

std::map<int, double> knownTimes(const ResultTable& table, const std::string& scene,
                                 const std::string& method) {
  std::map<int, double> known;
  for (const Result& r : table.rows())
    if (r.scene == scene && r.method == method) known[r.spp] = r.cpu_ms;
  return known;
}

}  // namespace

int pathsWithin(double budget_ms, int step, std::map<int, double>& known, const MeasureTime& time_of) {
  for (int tries = 0;; ++tries) {
    const auto low = mostWithin(known, budget_ms);
    if (low == known.end() && known.contains(step)) return 0;
    const bool done =
        low != known.end() && (low->second >= kClose * budget_ms || known.contains(low->first + step));
    if (done || tries == kTries) return low == known.end() ? 0 : low->first;
    const int next = low == known.end() ? step : nextGuess(budget_ms, step, known, low);
    if (known.contains(next) || next > ranges::kSpp.max) return low->first;
    known[next] = time_of(next);
  }
}

std::vector<EqualTimeRow> measureEqualTimes(const Bench& bench, const std::string& scene,
                                            const std::vector<std::string>& methods,
                                            const std::vector<double>& budgets, const BenchOptions& o,
                                            ResultTable& table, const TimeBench& times) {
  const auto measured = [&](const MethodSpec& method, int spp) {
    return measure(bench, scene, method, spp, o, table, &times);
  };
  const double unit_ms = measured(parseMethod(defaultMethod(true).name), kBudgetPaths).cpu_ms;
  Progress progress(scene + " at equal time", static_cast<double>(methods.size() * budgets.size()));
  std::vector<EqualTimeRow> rows;
  for (const std::string& text : methods) {
    const MethodSpec method = parseMethod(text);
    std::map<int, double> known = knownTimes(table, scene, text);
    for (const double budget : budgets) {
      EqualTimeRow row{scene, text, budget, budget * unit_ms, {}};
      const int spp = pathsWithin(row.budget_ms, method.takes(1) ? 1 : 2, known,
                                  [&](int n) { return measured(method, n).cpu_ms; });
      if (spp > 0) row.result = measured(method, spp);
      rows.push_back(row);
      progress.add(1);
    }
  }
  return rows;
}

}  // namespace saccade::eval
