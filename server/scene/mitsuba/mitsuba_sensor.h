// The camera of a Mitsuba scene file.
#pragma once

#include "scene/mitsuba/xml_file.h"
#include "scene/scene.h"

namespace saccade {

// Sets the pose, field of view and picture size of `scene`. Throws SceneError.
void readSensor(const XmlFile& file, pugi::xml_node sensor, Scene& scene);

}  // namespace saccade
