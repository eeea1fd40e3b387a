// Points of pixels at any times, for methods that know light on surfaces. Pure data.
#pragma once

#include <cstdint>

#include "frame/surface_samples.h"

namespace saccade {

// A pixel at one of a few times.
struct PixelMoment {
  std::uint16_t x, y;
  std::uint32_t moment;  // number of the time
};

// A point that a pixel shows. I = emission + albedo i, with the illumination i at the place.
struct PointSample {
  SurfacePlace place;                     // unless the kind is kNone
  SurfaceKind kind = SurfaceKind::kNone;  // kNone where it reflects nothing, or light that cannot be shared
  bool light_moves = false;               // as of SurfacePoint
  float albedo = 0;                       // luminance
  float emission = 0;                     // luminance, with what it reflects of lamps without extent

  // Whether it reflects light that depends on the view, so that no look-up tells it.
  bool isUncacheable() const { return albedo > 0 && kind == SurfaceKind::kNone; }
};

// The light that a method knows at a place: i = place.unoccluded * visibility + residual.
struct PlaceLight {
  bool known = false;
  float residual = 0;
  float visibility = 1;
  float shadow = 0;             // variance of visibility that rays may tell; 0: they cannot
  bool shadow_visible = false;  // whether it is a visible part of the light
};

}  // namespace saccade
