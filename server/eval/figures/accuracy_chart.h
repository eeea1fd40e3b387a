// Draws error against CPU time: a panel for each scene and metric, a line for each method.
#pragma once

#include <string>
#include <vector>

#include "eval/bench/compared_methods.h"
#include "eval/bench/results.h"

namespace saccade::eval {

struct AccuracyChart {
  std::vector<std::string> scenes;  // names or paths, see open_scene.h
  std::vector<std::string> methods = comparedMethods();
  std::vector<int> spp{1, 2, 4, 8, 32, 128};
  std::vector<std::string> metrics{"dI_l1",         "dL_l1",    "false_events",
                                   "missed_events", "sigma_dL", "voxel_error"};
};

// Throws CLI::ValidationError, which lists the metrics.
const ScoreColumn& findMetric(const std::string& name);

// SVG of the rows that the table has. Error bars are standard errors over the seeds.
std::string drawAccuracyChart(const AccuracyChart& chart, const ResultTable& table);

}  // namespace saccade::eval
