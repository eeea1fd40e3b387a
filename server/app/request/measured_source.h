// The measured tables that the server found when it started.
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
using AccuracySource = MeasuredSource<AccuracyTable>;              // for Quality.budget_ms, max_false_rate
using SimplificationSource = MeasuredSource<SimplificationTable>;  // for Quality.max_event_change

struct MeasuredTables {
  AccuracySource accuracy;
  SimplificationSource simplification;
};

// Read `path`; empty: no table. They do not use one that was measured on another processor, and log what they
// found. They throw std::runtime_error where the file is faulty, but only log it for the default file, which
// nobody asked for.
AccuracySource openAccuracySource(const std::string& path);
SimplificationSource openSimplificationSource(const std::string& path);

}  // namespace saccade
