// The tables that were measured on this machine, as they were found when the server started.
#pragma once

#include <string>

#include "saccade/v1/control.pb.h"
#include "tables/accuracy_table.h"
#include "tables/simplification_table.h"

namespace saccade {

template <class Table>
struct MeasuredSource {
  Table table;
  std::string unavailable;  // empty, or why it cannot be used and what to do about it

  v1::BudgetInfo info() const;
};
using AccuracySource = MeasuredSource<AccuracyTable>;              // budgets are answered from it
using SimplificationSource = MeasuredSource<SimplificationTable>;  // and Quality.max_event_change

struct MeasuredTables {
  AccuracySource accuracy;
  SimplificationSource simplification;
};

// Read `path`, which may be empty: no table. One that was measured on another processor is not used. They say
// in the log what they found. They throw std::runtime_error where the file is faulty, unless it is the
// default one, which nobody has asked for.
AccuracySource openAccuracySource(const std::string& path);
SimplificationSource openSimplificationSource(const std::string& path);

}  // namespace saccade
