// Classical algorithms that users run on events, and their errors.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "eval/bench/sequence.h"
#include "eval/tasks/task_truth.h"

namespace saccade::eval {

struct TaskInput {
  const Events& events;           // of all scored frames, in time order
  const ChangeSequence& changes;  // of the same frames, as a method estimates them: their pictures
  double threshold, bias;         // C of both polarities, and I_eps, of the sensor
  const TaskTruth& truth;
};

struct TaskScore {
  double error = std::numeric_limits<double>::quiet_NaN();  // 0 is perfect; NaN without an answer
  std::size_t answers = 0;                                  // how many estimates it is over
};

struct Task {
  const char *name, *what;
  const char* error;  // what the error is, for the axis of a chart
  bool (*applies)(const TaskTruth& truth);
  TaskScore (*score)(const TaskInput& input);  // throws Interrupted
};

// THE list of tasks.
const std::vector<Task>& taskTable();

// Each in the file of its algorithm.
TaskScore scoreNormalFlow(const TaskInput& input);
TaskScore scorePatchFlow(const TaskInput& input);
TaskScore scoreRotation(const TaskInput& input);
TaskScore scoreEgoVelocity(const TaskInput& input);
TaskScore scoreMovingObjects(const TaskInput& input);
TaskScore scoreHighPass(const TaskInput& input);
TaskScore scoreComplementary(const TaskInput& input);
TaskScore scoreCornerTracks(const TaskInput& input);

}  // namespace saccade::eval
