// What every part of a scene's model costs and changes, as `saccade-eval simplification` measured it on one
// machine; and which of it to leave out.
#pragma once

#include <string>
#include <vector>

#include "render/simplify.h"

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
  // Of the picture of many paths, against that of the whole model, per pixel-frame.
  double false_events = 0, missed_events = 0;
  double changed = 0;  // both, over the events of the whole model, noise taken off
  double noise = 0;    // what the noise of both pictures alone would change, over the same
};

struct SimplificationTable {
  std::string settings;  // all that the rows share, as the file says it: "cpu=... trajectory=... size=..."
  std::string cpu;       // as cpuName() says it
  std::vector<MeasuredModel> rows;  // the first of a scene is its whole model, which changes nothing

  std::vector<std::string> scenes() const;  // sorted
  // Of one scene; empty where it is not measured.
  std::vector<MeasuredModel> modelsOf(const std::string& scene) const;
};

// Both throw std::runtime_error, of a faulty file with its line.
SimplificationTable readSimplificationTable(const std::string& path);
void writeSimplificationTable(const std::string& path, const SimplificationTable& table);  // makes the folder

// Where it stands unless it is said otherwise.
std::string defaultSimplificationTable();

// The least CPU time among those that change at most `tolerance` of the events, where noise alone would not
// change more. `models`: the whole one first.
const MeasuredModel& cheapest(const std::vector<MeasuredModel>& models, double tolerance);

}  // namespace saccade
