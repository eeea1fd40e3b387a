// Results and cells written out by hand.
#pragma once

#include "eval/bench/ratios.h"

namespace saccade::eval::test {

// Every figure is `figure`; the truth's own error of dI is a tenth of 1, and its own events are a hundredth.
inline Result result(const std::string& method, double figure) {
  Result r;
  r.method = method, r.spp = 2, r.cpu_ms = figure, r.px_per_frame = 0.66, r.reference_error = 0.1;
  r.reference_events = 0.01;
  for (const ScoreColumn& column : kScoreColumns) r.score.*column.value = figure;
  return r;
}

// Of a baseline and a candidate with these figures.
inline ComparedCell comparedCell(double speed, double baseline, double candidate) {
  return {{"box", "right", speed, {21, 21}}, "", {result("old", baseline)}, {result("new", candidate)}};
}

inline const ComparedColumn& column(const std::string& name) {
  for (const ComparedColumn& c : kComparedColumns)
    if (name == c.name) return c;
  std::abort();
}

}  // namespace saccade::eval::test
