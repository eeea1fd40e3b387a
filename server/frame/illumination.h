// Illumination: the light that a pixel reflects, over its albedo.
#pragma once

#include <algorithm>

#include "frame/frame.h"

namespace saccade {

inline constexpr float kAlbedoFloor = 1e-3f;  // in both directions; modulation keeps an albedo of 0

// The divisor of the light that a pixel reflects.
inline float divisorOf(const GBuffer& g, int x, int y) {
  return std::max(g.albedo.at(x, y), kAlbedoFloor);
}

// i = (I - E) / A [E (17)], for the radiance I of a pixel.
inline float illuminationOf(const GBuffer& g, int x, int y, float I) {
  return (I - g.emission.at(x, y)) / divisorOf(g, x, y);
}

}  // namespace saccade
