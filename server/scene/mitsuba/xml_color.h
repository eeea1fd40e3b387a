// Colours of a scene file.
#pragma once

#include "base/vec.h"
#include "scene/mitsuba/xml_file.h"

namespace saccade {

enum class ColorUse {
  kShare,     // of the light at each wavelength, such as a reflectance: seen under daylight
  kQuantity,  // such as a radiance
};

// Takes <rgb>, <srgb>, <spectrum> or <float>: a number, three, #rrggbb, or for <spectrum> a list of nm:value.
// The colour is linear Rec. 709; spectrum.h says how lists become one. There parts below 0 become 0, and
// shares above 1 become 1. Throws SceneError that names the line.
Rgb parseColor(const XmlFile& file, pugi::xml_node node, ColorUse use);

}  // namespace saccade
