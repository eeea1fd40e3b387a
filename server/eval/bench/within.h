// Finds the setting that keeps a limit: `saccade-eval chart --within 20ms --within 2%`.
#pragma once

#include <optional>
#include <string>

#include "tables/accuracy_table.h"

namespace saccade::eval {

// Exactly one is set.
struct Within {
  std::optional<double> budget_ms;       // CPU milliseconds per frame, over all threads
  std::optional<double> max_false_rate;  // false events per pixel-frame
};

// "20ms", "2%". Throws std::runtime_error naming both forms.
Within parseWithin(const std::string& text);

// A line for each scene, with time and error rates. It is the most accurate setting within the time, or the
// fastest within the rate, at the size and C of the table. Without one the line names the nearest.
std::string answerWithin(const AccuracyTable& table, const Within& within);

}  // namespace saccade::eval
