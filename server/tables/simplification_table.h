// The table of `saccade-eval simplification`: the CPU time of simplified models of scenes on one machine, and
// the events that they change. Chooses a model from it.
#pragma once

#include <string>
#include <vector>

#include "render/features/simplify.h"

namespace saccade {

struct SceneModel {
  int bounces = 3;  // indirect
  SceneFeatures disabled_features;

  std::string text() const;  // "2 bounces, without textures, masks"
  friend bool operator==(const SceneModel&, const SceneModel&) = default;
};

struct MeasuredModel {
  std::string scene;
  SceneModel model;
  double cpu_ms = 0;  // per frame, over all threads, of tracing and filter
  // Per pixel-frame, of references of this model against those of the whole one.
  double false_events = 0, missed_events = 0;
  double changed = 0;  // both, as a share of the whole model's events, without the part due to noise
  double noise = 0;    // the share that the noise of the references changes
};

struct SimplificationTable {
  std::string settings;             // of all rows, as in the file: "cpu=... trajectory=... size=..."
  std::string cpu;                  // cpuName() of the machine
  std::vector<MeasuredModel> rows;  // the first row of a scene is its whole model, which changes nothing

  std::vector<std::string> scenes() const;  // sorted
  // The models of the scene with this name; empty if it has none. Nothing else is compared: the shares hold
  // for the threshold, view and trajectory in `settings`.
  std::vector<MeasuredModel> modelsOf(const std::string& scene) const;
};

// Both throw std::runtime_error, of a faulty file with its line.
SimplificationTable readSimplificationTable(const std::string& path);
void writeSimplificationTable(const std::string& path, const SimplificationTable& table);  // makes the folder

// The default path of the file.
std::string defaultSimplificationTable();

// The model with the least CPU time that changes at most `tolerance` of the events, and whose noise is at
// most `tolerance` too. `models`: the whole one first.
const MeasuredModel& cheapest(const std::vector<MeasuredModel>& models, double tolerance);

}  // namespace saccade
