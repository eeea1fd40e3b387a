// Draws the errors of events in time against CPU time: a line for each way to divide time.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "eval/bench/time_truth.h"

namespace saccade::eval {

struct TimeSeries {
  std::string name;                                        // "whole frames"
  std::vector<std::pair<std::string, TimeTruthRow>> rows;  // by label
};

// SVG. Rows without an error, such as those of a picture that rests, have no place on the axes.
std::string drawTimeChart(const std::string& title, const std::vector<TimeSeries>& series);

}  // namespace saccade::eval
