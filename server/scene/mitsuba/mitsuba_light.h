// The emitters of a Mitsuba scene file that belong to no shape.
#pragma once

#include "scene/files/file_loads.h"
#include "scene/mitsuba/xml_file.h"
#include "scene/scene.h"

namespace saccade {

// Adds an <emitter> that is no area to `scene`; `loads` will read or compute its picture.
// Throws SceneError.
void readLight(const XmlFile& file, pugi::xml_node emitter, FileLoads& loads, Scene& scene);

}  // namespace saccade
