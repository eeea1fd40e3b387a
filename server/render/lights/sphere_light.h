// The light of a sphere in closed form.
#pragma once

#include "render/lights/analytic_light.h"

namespace saccade {

// The share of the cosine-weighted hemisphere above a point that a sphere covers, as if nothing cast a
// shadow. Points inside get nothing.
float sphereFormFactor(Vec3 center, float radius, const LitPoint& p);

}  // namespace saccade
