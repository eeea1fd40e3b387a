// Compares candidates with baselines over the cells of `saccade-eval cells`.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "eval/bench/cells.h"
#include "eval/bench/results.h"

namespace saccade::eval {

struct ComparedColumn {
  const char* name;
  double (*of)(const Result&);          // lower is better
  double Result::*reference = nullptr;  // the truth's own error in this unit, where it counts as an error
};
inline constexpr std::array<ComparedColumn, 9> kComparedColumns{{
    {"cpu_ms", [](const Result& r) { return r.cpu_ms; }},
    {"dI_l1", [](const Result& r) { return r.score.dI_l1; }, &Result::reference_error},
    {"dI_error", [](const Result& r) { return r.score.dI_error; }},
    {"dL_l1", [](const Result& r) { return r.score.dL_l1; }},
    {"dL_error", [](const Result& r) { return r.score.dL_error; }},
    {"false_events", [](const Result& r) { return r.score.false_events; }, &Result::reference_events},
    {"missed_events", [](const Result& r) { return r.score.missed_events; }, &Result::reference_events},
    {"sigma_dL", [](const Result& r) { return r.score.sigma_dL; }},
    {"phase_error", [](const Result& r) { return r.score.phase_error; }},
}};

// One cell, measured or left out. All results are against one truth.
struct ComparedCell {
  Cell cell;
  std::string left_out = {};  // empty, or why
  std::vector<Result> baselines = {}, candidates = {};
};

// Why a ratio does not count in a mean.
enum class Mark {
  kNone,     // it counts
  kUnknown,  // a figure is unknown or infinite
  kNoBase,   // the baseline's figure is 0, or lost in the noise
  kNothing,  // the candidate's figure is 0, or lost in the noise: no factor, but a win
  kNoise,    // the baseline's figure is below kTold times the error of the truth itself
};
inline constexpr double kTold = 3;
const char* textOf(Mark mark);  // for tables; empty for kNone

struct Ratio {
  double value;            // candidate over the better baseline, NaN for kUnknown and kNoBase
  const Result* baseline;  // the better one; nullptr where it is unknown
  Mark mark;
};
// The ratio of a candidate of this cell. Of the baselines the lowest known figure counts, column by column.
Ratio ratioOf(const Result& candidate, const std::vector<Result>& baselines, const ComparedColumn& column);

struct RatioSummary {
  double mean;             // geometric, of the ratios that count; NaN without one
  int counted, marked;     // cells
  double largest;          // of those that count; NaN without one
  std::string largest_in;  // the name of its cell
};
// Over the cells that are not left out; `candidate` is the place in their list.
RatioSummary summarize(const std::vector<ComparedCell>& cells, std::size_t candidate,
                       const ComparedColumn& column);

}  // namespace saccade::eval
