// A bound of the light of a lamp, or of a group: where it is, where it shines, and how strongly.
#pragma once

#include "base/vec.h"

namespace saccade {

struct LampBounds {
  Vec3 low, high;      // corners of its box
  Vec3 axis;           // unit: the middle of the directions in which it shines most
  float spread = 0;    // radians: of these directions about the axis; pi: all
  float dark = 0;      // the cosine with them from which on it does not shine
  float bright = 1;    // the cosine with them up to which it shines fully
  float strength = 0;  // irradiance at the distance 1, facing it

  Vec3 centre() const { return (low + high) * 0.5f; }
  float radius() const { return length(high - low) / 2; }
};

// Of both together. The cones are those of Conty Estevez and Kulla (2018), algorithm 1.
LampBounds merged(const LampBounds& a, const LampBounds& b);

}  // namespace saccade
