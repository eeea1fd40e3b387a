// The depth of the author's picture, from the integrator of a Mitsuba scene file.
#pragma once

#include <optional>
#include <vector>

#include "scene/mitsuba/xml_file.h"

namespace saccade {

// Indirect bounces, from the max_depth of the first of the integrators that has one, also within others.
// Mitsuba counts the edges of a path from the camera on: 1 shows lamps alone, 2 direct light. None: without
// one, or with a depth below 1, which is endless. Throws SceneError where it is no number.
std::optional<int> readBounces(const XmlFile& file, std::vector<pugi::xml_node> integrators);

}  // namespace saccade
