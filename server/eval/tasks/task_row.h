// The scores of tasks as rows, and as a table.
#pragma once

#include <string>
#include <vector>

#include "eval/tasks/task.h"

namespace saccade::eval {

inline const std::string kReferenceSource = "reference", kNoNoise = "none";

// The scores of one task on the events of one source, seen by one sensor.
struct TaskRow {
  std::string scene, noise, method;  // the name of the noise, and a method or kReferenceSource
  int spp = 0;                       // paths per pixel and frame
  const Task* task = nullptr;
  std::vector<TaskScore> scores = {};  // of runs with other seeds
  double cpu_ms = 0;                   // of rendering, per frame, mean over the runs; 0 of the reference
  double events = 0;                   // per pixel and frame, noise included, mean over the runs

  double error() const;          // mean over the scores with an answer; NaN if none has
  double standardError() const;  // of it, over the seeds; NaN of less than two
  double answers() const;        // mean over all scores
  std::string view() const;      // the scene and the noise, as a title
  bool sameView(const TaskRow& other) const { return scene == other.scene && noise == other.noise; }
  bool isReference() const { return method == kReferenceSource; }
};

std::string csvOf(const std::vector<TaskRow>& rows);
// A table for each scene and noise: a line for each source, and a column for each task.
std::string tableOf(const std::vector<TaskRow>& rows);

}  // namespace saccade::eval
