// The table that budgets are answered from, as it was found when the server started.
#pragma once

#include <string>

#include "methods/accuracy_table.h"
#include "saccade/v1/control.pb.h"

namespace saccade {

struct AccuracySource {
  AccuracyTable table;
  std::string unavailable;  // empty, or why there are no budgets and what to do about it

  v1::BudgetInfo info() const;
};

// Reads `path`, which may be empty: no table. One that was measured on another processor is not used. Says in
// the log what it found. Throws std::runtime_error where the file is faulty, unless it is the default one,
// which nobody has asked for.
AccuracySource openAccuracySource(const std::string& path);

}  // namespace saccade
