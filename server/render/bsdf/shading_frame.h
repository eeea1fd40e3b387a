// The frame in which BSDFs are written: z is the shading normal, and x and y complete it.
#pragma once

#include "base/vec.h"

namespace saccade {

struct ShadingFrame {
  // About the unit vector n, without a singularity (Duff et al. 2017).
  explicit ShadingFrame(Vec3 n) : z(n) {
    const float sign = std::copysign(1.f, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
    x = {1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
    y = {b, sign + n.y * n.y * a, -n.y};
  }

  Vec3 toWorld(Vec3 w) const { return x * w.x + y * w.y + z * w.z; }
  Vec3 toLocal(Vec3 w) const { return {dot(w, x), dot(w, y), dot(w, z)}; }

  Vec3 x, y, z;
};

}  // namespace saccade
