// The <transform> of a Mitsuba scene file.
#pragma once

#include "base/affine.h"
#include "scene/mitsuba/xml_file.h"

namespace saccade {

// Its matrix, translate, rotate, scale and lookat elements, applied in order; the identity if `node` is null.
// Throws SceneError: another element, numbers that are missing, a map that flattens space or is not affine.
Affine parseTransform(const XmlFile& file, pugi::xml_node node);

}  // namespace saccade
