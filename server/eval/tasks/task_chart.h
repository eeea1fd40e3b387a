// Draws the errors of tasks against the CPU time of rendering.
#pragma once

#include <string>
#include <vector>

#include "eval/tasks/task_row.h"

namespace saccade::eval {

// SVG: for each scene and noise a group of panels, one for each task, with a line for each method. The error
// of the reference is a black line. All groups must have the same tasks.
std::string chartOf(const std::vector<TaskRow>& rows);

}  // namespace saccade::eval
