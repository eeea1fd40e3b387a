// Writes the table of Figure 5.
#pragma once

#include <string>
#include <vector>

#include "eval/figures/false_events.h"

namespace saccade::eval {

struct FalseEventRow {
  std::string scene, method;
  int spp;
  double C;
  FalseEvents counted;
};

// CSV with a header; noise in the unit of dL.
std::string csvOf(const std::vector<FalseEventRow>& rows);
// Prints a table on stdout; noise in the unit C.
void printRows(const std::vector<FalseEventRow>& rows);

}  // namespace saccade::eval
