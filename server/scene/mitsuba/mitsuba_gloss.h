// Types of <bsdf> that Mitsuba 0.6 has, and Mitsuba 3 has not.
#pragma once

#include "scene/mitsuba/bsdf_values.h"

namespace saccade {

inline constexpr const char* kRoughDiffuse = "roughdiffuse";  // shown as diffuse

// All throw SceneError. readRoughDiffuse() leaves the reflectance to the reader of diffuse.
void readPhong(BsdfSource& from, Material& material);
void readWard(BsdfSource& from, Material& material);
void readRoughDiffuse(BsdfSource& from);

}  // namespace saccade
