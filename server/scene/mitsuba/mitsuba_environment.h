// Emitters around the scene.
#pragma once

#include "base/affine.h"
#include "scene/mitsuba/xml_file.h"
#include "scene/scene.h"

namespace saccade {

// The rotation or reflection of an emitter's to_world, without its scale and translation. Throws SceneError
// where it shears.
Affine orthonormal(const XmlFile& file, pugi::xml_node emitter, const Affine& map);

// Throws SceneError where the scene has an environment.
void addEnvironment(const XmlFile& file, pugi::xml_node emitter, Scene& scene, Environment environment);

}  // namespace saccade
