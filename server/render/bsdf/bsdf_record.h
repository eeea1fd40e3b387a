// The arguments and results of BSDFs. Directions are unit vectors in the shading frame and point away from
// the surface. The camera's side of the path is at wo, and the light at wi. The normal is z. The normal of a
// dielectric points outside.
#pragma once

#include "render/bsdf/bsdf_tables.h"

namespace saccade {

// A material at one point, with its textures looked up. Colours are linear, in [0, 1].
struct Bsdf {
  const BsdfTables* tables;    // of the material
  Rgb diffuse{};               // diffuse, plastics, metallic-roughness: reflectance of the base
  Rgb specular{1, 1, 1};       // all but diffuse: factor of what the interface reflects; metallic-roughness:
                               // its reflectance at a right angle
  Rgb transmittance{1, 1, 1};  // dielectrics: factor of what it lets through
  float alpha = 1;             // metallic-roughness: of its microfacets, at least kLeastAlpha
};

// The value for a pair of directions. Delta lobes, which reflect into one direction only, count as 0.
struct BsdfValue {
  Rgb value{};    // f |cos_i|
  float pdf = 0;  // of sampling wi, per solid angle
};

struct BsdfSample {
  Vec3 wi;
  Rgb weight;        // f |cos_i| / pdf; 0: no light comes from there
  float pdf;         // per solid angle, of all lobes; delta: the probability of its lobe; 0: weight is 0
  bool delta;        // of a delta lobe, which has no value in evaluateBsdf()
  bool transmitted;  // wi is on the other side
};

// `value` if the condition holds, otherwise 0.
inline float valueIf(bool condition, float value) {
  return condition ? value : 0;
}

// A sample of a lobe that is no delta lobe.
inline BsdfSample weigh(Vec3 wi, BsdfValue v) {
  return {wi, v.value * (v.pdf > 0 ? 1 / v.pdf : 0.f), v.pdf, false, false};
}

}  // namespace saccade
