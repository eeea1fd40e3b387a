// Lights that are not surfaces of the scene.
#pragma once

#include <cmath>
#include <string>

#include "base/affine.h"
#include "base/vec.h"
#include "scene/body.h"
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
  Rgb intensity;          // power per solid angle
  std::string name = {};  // empty: none, so that nothing moves it
  int body = kStands;     // of Scene::bodies
};

// As a point, but within a cone alone: fully up to the angle `beam` from its axis. From there it falls in
// proportion to the angle, down to 0 at `cutoff`, as in Mitsuba 3.
struct SpotLight {
  Vec3 position;
  Vec3 axis;  // in which it shines; unit
  Rgb intensity;
  float beam, cutoff;     // radians, at most pi; the beam is at most the cutoff
  std::string name = {};  // as of a point
  int body = kStands;
};

// In a unit direction away from the lamp.
inline Rgb intensityTowards(const SpotLight& light, Vec3 direction) {
  const float angle = std::acos(std::fmin(1.f, std::fmax(-1.f, dot(light.axis, direction))));
  if (angle <= light.beam) return light.intensity;
  if (angle >= light.cutoff) return {};
  return light.intensity * ((light.cutoff - angle) / (light.cutoff - light.beam));
}

struct DirectionalLight {
  Vec3 direction;         // in which its light goes; unit
  Rgb irradiance;         // on a surface at a right angle to it
  std::string name = {};  // as of a point
  int body = kStands;     // it turns with it
};

}  // namespace saccade
