// The emitters of a Mitsuba scene file that are the surface of a shape.
#pragma once

#include "scene/mitsuba/xml_file.h"
#include "scene/scene.h"

namespace saccade {

struct Emission {
  Rgb radiance;
  Strength strength;
};

// Reads the <emitter type="area"> of a shape. Throws SceneError.
Emission parseEmitter(const XmlFile& file, pugi::xml_node emitter);

}  // namespace saccade
