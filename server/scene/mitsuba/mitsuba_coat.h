// A <bsdf> of the type coating or roughcoating: a dielectric layer over another.
#pragma once

#include "scene/mitsuba/bsdf_values.h"

namespace saccade {

bool isCoat(const std::string& type);

// Lays the coat over the material within it. Throws SceneError.
void readCoat(BsdfSource coat, Material& material);

}  // namespace saccade
