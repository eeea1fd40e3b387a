// Leaves out parts of a scene's model. The result is a scene like any other, and the renderer needs no
// switches. It takes the smallest kernel that covers the scene.
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
  std::string description;  // its replacement
  bool (*isIn)(const Scene& scene);
  void (*leaveOut)(Scene& scene);
};

// All features, in the order in which they are left out.
const std::vector<SceneFeatureInfo>& featureTable();
const SceneFeatureInfo* findFeature(const std::string& name);  // nullptr if there is none
std::string featureNames();                                    // "textures, specular, ...", for messages

SceneFeatures featuresOf(const Scene& scene);
std::vector<std::string> namesOf(const SceneFeatures& parts);  // in the order of the table

// `scene` without these features, and without the bitmaps that no surface shows any more. A feature that the
// scene lacks changes nothing.
Scene simplified(Scene scene, const SceneFeatures& disabled);

}  // namespace saccade
