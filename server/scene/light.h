// Lights that are not surfaces of the scene.
#pragma once

#include "base/vec.h"
#include "scene/affine.h"
#include "scene/files/picture.h"

namespace saccade {

// Radiance from infinitely far away, in all directions. The picture shows the unit direction (x, y, z) of
// its own space at atan2(x, -z) / 2 pi of the picture's width, modulo 1. That is at acos(y) / pi of the
// picture's height from the top, as in Mitsuba.
struct Environment {
  Rgb radiance;     // of all directions, or a factor on the picture
  Picture picture;  // linear, at least 0; without pixels: `radiance` alone
  Affine to_world;  // of the picture: orthonormal, may mirror
};

struct PointLight {
  Vec3 position;
  Rgb intensity;  // power per solid angle
};

struct DirectionalLight {
  Vec3 direction;  // in which its light goes; unit
  Rgb irradiance;  // on a surface at a right angle to it
};

}  // namespace saccade
