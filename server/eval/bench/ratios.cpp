#include "eval/bench/ratios.h"

#include <cmath>
#include <limits>

namespace saccade::eval {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// The baseline with the lowest known figure, or nullptr.
const Result* betterOf(const std::vector<Result>& baselines, const ComparedColumn& column) {
  const Result* best = nullptr;
  for (const Result& r : baselines) {
    if (std::isfinite(column.of(r)) && (!best || column.of(r) < column.of(*best))) best = &r;
  }
  return best;
}

}  // namespace

const char* textOf(Mark mark) {
  constexpr std::array<const char*, 5> kTexts{"", "unknown", "no error of the baseline",
                                              "no error of the candidate", "error of the reference"};
  return kTexts[static_cast<std::size_t>(mark)];
}

Ratio ratioOf(const Result& candidate, const std::vector<Result>& baselines, const ComparedColumn& column) {
  const Result* base = betterOf(baselines, column);
  const double figure = column.of(candidate);
  if (!base || !std::isfinite(figure)) return {kNaN, base, Mark::kUnknown};
  const double least = column.of(*base);
  if (least <= 0) return {kNaN, base, Mark::kNoBase};
  if (figure <= 0) return {0, base, Mark::kNothing};
  const bool is_told = !column.reference || least >= kTold * base->*column.reference;
  return {figure / least, base, is_told ? Mark::kNone : Mark::kNoise};
}

RatioSummary summarize(const std::vector<ComparedCell>& cells, std::size_t candidate,
                       const ComparedColumn& column) {
  RatioSummary s{kNaN, 0, 0, kNaN, {}};
  double logs = 0;
  for (const ComparedCell& cell : cells) {
    if (!cell.left_out.empty()) continue;
    const Ratio ratio = ratioOf(cell.candidates[candidate], cell.baselines, column);
    if (ratio.mark != Mark::kNone) {
      ++s.marked;
      continue;
    }
    ++s.counted, logs += std::log(ratio.value);
    if (!(ratio.value <= s.largest)) s.largest = ratio.value, s.largest_in = cell.cell.name();
  }
  if (s.counted > 0) s.mean = std::exp(logs / s.counted);
  return s;
}

}  // namespace saccade::eval
