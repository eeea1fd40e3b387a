// The emitters sky, sun and sunsky of a Mitsuba scene file.
#pragma once

#include "scene/files/file_loads.h"
#include "scene/mitsuba/xml_properties.h"
#include "scene/scene.h"

namespace saccade {

// Adds the sky as an environment, and the sun as a directional light; `loads` will compute the picture of the
// sky. Up is +y, east +x and north -z for Mitsuba 0.4 to 0.6; up is +z, north -x and east -y for Mitsuba 3.
// Both are by other models than Mitsuba's, see preetham_sky.h and sun.h; Scene::unread tells it. Throws
// SceneError.
void readSky(const XmlFile& file, pugi::xml_node emitter, const std::string& type, Properties& properties,
             FileLoads& loads, Scene& scene);

}  // namespace saccade
