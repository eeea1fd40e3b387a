// The table of Figure 5.
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

std::string csvOf(
    const std::vector<FalseEventRow>& rows);             // for machines, header first; noise in units of dL
void printRows(const std::vector<FalseEventRow>& rows);  // for people, on stdout; noise in units of C

}  // namespace saccade::eval
