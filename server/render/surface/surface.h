// A point on a surface, ready for shading.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/surface/shading.h"

namespace saccade {

struct Surface {
  Vec3 point;
  float offset;                           // of rays that leave it, see ray_offset.h
  Vec3 geometric_normal, shading_normal;  // unit, on the side the ray came from
  Bsdf bsdf;                              // black behind a one-sided material
  Rgb radiance;                           // emitted towards the ray's origin at strength 1

  bool inside;    // of glass: the ray came from behind the material's own normal
  float opacity;  // the rest of the light goes straight on
};

// The origin of a ray that leaves the surface. It is moved off the surface, so that the ray does not hit it
// again. It lies on the side that the last ray came from, or on the other side for `through`.
inline Vec3 leave(const Surface& s, bool through = false) {
  return s.point + s.geometric_normal * (through ? -s.offset : s.offset);
}

// The least cosine of the direction that a path came from, for surfaces that are not diffuse.
inline constexpr float kGrazingCosine = 1e-3f;

// The width of the region that one path stands for, along a ray and at a right angle to it. Textures are
// averaged over this width. Widths are in scene units [Akenine-Moller 2021].
struct RayCone {
  float width, spread;  // at the ray's origin; growth per unit of t

  static constexpr float kDiffuseSpread = 0.25f;  // so wide that coarse mips are enough

  float at(float t) const { return width + spread * t; }
  // The spread behind a rough surface, for a sample of this pdf per solid angle.
  static float lobeSpread(float pdf) {
    return kDiffuseSpread * std::min(1.f, 1 / std::sqrt(std::numbers::pi_v<float> * pdf));
  }
};

}  // namespace saccade
