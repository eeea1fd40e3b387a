// A scene with parts of its model left out. What remains is a scene like any other, so that the renderer,
// which takes the least that holds a scene, needs no switches.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace saccade {

enum class SceneFeature { kTextures, kSpecular, kBumpMaps, kMasks, kEnvironment, kMipFiltering };
using SceneFeatures = std::set<SceneFeature>;

struct SceneFeatureInfo {
  SceneFeature feature;
  std::string name;         // "textures"
  std::string description;  // what takes its place
  bool (*isIn)(const Scene& scene);
  void (*leaveOut)(Scene& scene);
};

// THE list, in the order in which parts are left out.
const std::vector<SceneFeatureInfo>& featureTable();
const SceneFeatureInfo* findFeature(const std::string& name);  // nullptr if there is none
std::string featureNames();                                    // "textures, specular, ...", for messages

SceneFeatures featuresOf(const Scene& scene);
std::vector<std::string> namesOf(const SceneFeatures& parts);  // in the order of the table

// `scene` without these parts, and without the bitmaps that nothing shows any more. What it lacks anyway
// changes nothing.
Scene simplified(Scene scene, const SceneFeatures& disabled);

}  // namespace saccade
