// Runs the tasks on the events of methods and of the reference.
#pragma once

#include <string>
#include <vector>

#include "eval/tasks/task_row.h"

namespace saccade::eval {

struct TaskSensor {
  std::string noise;  // a name for the rows
  SensorConfig config;
};

struct TaskPlan {
  std::string scene;  // a name for the rows
  std::vector<const Task*> tasks;
  std::vector<TaskSensor> sensors;  // at least one, all of one bias
  std::vector<std::string> methods;
  std::vector<int> spp;
  int repeats = 1;  // runs with other seeds, of methods and of sensors
};

// By sensor and source, with the reference first, and then by task. Leaves out tasks that do not apply. Shows
// its progress. Each method must take all of `spp`. Throws Interrupted, and std::runtime_error where no task
// applies.
std::vector<TaskRow> runTasks(const Bench& bench, const TaskPlan& plan, TilePool& pool);

}  // namespace saccade::eval
