// Numbers as YAML. Readers of YAML 1.1 take 1e-05 for a text, so that each number has a point.
#pragma once

#include <string>
#include <vector>

#include "client/calibration/rig.h"

namespace saccade::client {

std::string yamlNumber(double value);                     // "1.0e-05", which reads back as the same number
std::string yamlList(const std::vector<double>& values);  // "[1.0, 2.0]"
// Rows as "- [1.0, 0.0]\n", after `indent`.
std::string yamlRows(const std::string& indent, const std::vector<double>& values, std::size_t columns);
std::string yamlRows(const std::string& indent, const Transform& transform);

}  // namespace saccade::client
