// A scene with parts of its model left out. What remains is a scene like any other, so that the renderer,
// which takes the least that holds a scene, needs no switches.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace saccade {

enum class Part { kTextures, kSpecular, kBumpMaps, kMasks, kEnvironment, kMipFiltering };
using Parts = std::set<Part>;

struct PartInfo {
  Part part;
  std::string name;         // "textures"
  std::string description;  // what takes its place
  bool (*isIn)(const Scene& scene);
  void (*leaveOut)(Scene& scene);
};

// THE list, in the order in which parts are left out.
const std::vector<PartInfo>& partTable();
const PartInfo* findPart(const std::string& name);  // nullptr if there is none
std::string partNames();                            // "textures, specular, ...", for messages

Parts partsOf(const Scene& scene);
std::vector<std::string> namesOf(const Parts& parts);  // in the order of the table

// `scene` without these parts, and without the bitmaps that nothing shows any more. What it lacks anyway
// changes nothing.
Scene simplified(Scene scene, const Parts& without);

}  // namespace saccade
