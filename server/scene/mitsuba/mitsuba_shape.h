// The shapes of a Mitsuba scene file.
#pragma once

#include "scene/mitsuba/mitsuba_material.h"
#include "scene/mitsuba/xml_file.h"
#include "scene/scene.h"

namespace saccade {

// Adds what a <shape> describes to the meshes or spheres of `scene`; `loads` will fill the meshes. Throws
// SceneError.
void readShape(const XmlFile& file, pugi::xml_node shape, MaterialReader& materials, FileLoads& loads,
               Scene& scene);

}  // namespace saccade
