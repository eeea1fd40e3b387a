// The encoding of sRGB [IEC 61966-2-1].
#pragma once

#include <cmath>

namespace saccade {

// A part of a colour, encoded and linear, in [0, 1].
inline double linearFromSrgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

}  // namespace saccade
