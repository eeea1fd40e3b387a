// The pixel of the frame before that showed the surface of a pixel.
#pragma once

#include <algorithm>
#include <cmath>

#include "frame/frame.h"

namespace saccade {

struct PixelPlace {
  int x, y;
};

// By the motion vector of (x, y), rounded; the nearest pixel inside the picture.
inline PixelPlace pixelBefore(const GBuffer& g, int x, int y) {
  const auto before = [](int now, float motion, int size) {
    const float at = std::round(static_cast<float>(now) + motion), last = static_cast<float>(size - 1);
    return static_cast<int>(at >= 0 ? std::min(at, last) : 0);  // 0 where the motion is no number
  };
  return {before(x, g.motion_x.at(x, y), g.z.width()), before(y, g.motion_y.at(x, y), g.z.height())};
}

}  // namespace saccade
