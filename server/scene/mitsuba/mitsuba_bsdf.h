// The BSDF at the bottom of a Mitsuba material.
#pragma once

#include "scene/mitsuba/bsdf_values.h"

namespace saccade {

// The types of <bsdf> that readBsdf() knows, such as "roughplastic".
std::vector<std::string> bsdfTypes();

// Fills in a material from a <bsdf> of one of these types. Throws SceneError.
void readBsdf(BsdfSource from, Material& material);

}  // namespace saccade
