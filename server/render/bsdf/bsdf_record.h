// What BSDFs take and give. Directions are unit vectors in the shading frame and point away from the surface:
// wo to where light goes (the camera's side of the path), wi to where it comes from. z is the normal; for
// dielectrics it points outside.
#pragma once

#include "render/bsdf/bsdf_tables.h"

namespace saccade {

// A material at one point: textures looked up. Colours are linear, in [0, 1].
struct Bsdf {
  const BsdfTables* tables;    // of the material
  Rgb diffuse{};               // diffuse, plastics: reflectance of the base
  Rgb specular{1, 1, 1};       // all but diffuse: factor of what the interface reflects
  Rgb transmittance{1, 1, 1};  // dielectrics: factor of what it lets through
};

// Of a pair of directions; both 0 for what happens at one direction only (delta lobes).
struct BsdfValue {
  Rgb value{};    // f |cos_i|
  float pdf = 0;  // of sampling wi, per solid angle
};

struct BsdfSample {
  Vec3 wi;
  Rgb weight;        // f |cos_i| / pdf; 0: nothing comes from there
  float pdf;         // per solid angle, of all lobes; delta: the probability of its lobe; 0: weight is 0
  bool delta;        // of a delta lobe, which no evaluation sees
  bool transmitted;  // wi is on the other side
};

// `value` if the condition holds, otherwise 0.
inline float valueIf(bool condition, float value) {
  return condition ? value : 0;
}

// A sample of the lobes that are no deltas.
inline BsdfSample weigh(Vec3 wi, BsdfValue v) {
  return {wi, v.value * (v.pdf > 0 ? 1 / v.pdf : 0.f), v.pdf, false, false};
}

}  // namespace saccade
