// Round shapes of a Mitsuba scene file as meshes.
#pragma once

#include <string>

#include "base/affine.h"
#include "scene/mitsuba/xml_properties.h"
#include "scene/scene.h"

namespace saccade {

// Whether a type of <shape> is one of these: cylinder, sphere.
bool isRound(const std::string& type);

// Of radius 1, see round_shapes.h.
Mesh makeRound(const std::string& type);

// From that mesh to the shape as its properties say; the identity for any other type. Throws SceneError.
Affine readRound(const XmlFile& file, pugi::xml_node shape, const std::string& type, Properties& properties);

}  // namespace saccade
