// The pixels around one.
#pragma once

#include <algorithm>

#include "frame/image.h"

namespace saccade {

// Calls f(u, v) for the pixels of a plane within `distance` of one on both axes, and for itself.
template <class F>
void forEachAround(const ImageF& plane, int x, int y, int distance, const F& f) {
  for (int v = std::max(y - distance, 0); v <= std::min(y + distance, plane.height() - 1); ++v)
    for (int u = std::max(x - distance, 0); u <= std::min(x + distance, plane.width() - 1); ++u) f(u, v);
}

}  // namespace saccade
