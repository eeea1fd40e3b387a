// The frame in which BSDFs are written: z is the shading normal, and x and y complete it.
#pragma once

#include "base/vec.h"

namespace saccade {

template <class F>
struct ShadingFrame {
  // About the unit vector n, without a singularity (Duff et al. 2017).
  explicit ShadingFrame(Vec3T<F> n) : z(n) {
    using std::copysign;
    const F sign = copysign(F(1), n.z), a = -1.f / (sign + n.z), b = n.x * n.y * a;
    x = {1.f + sign * n.x * n.x * a, sign * b, -sign * n.x};
    y = {b, sign + n.y * n.y * a, -n.y};
  }

  Vec3T<F> toWorld(Vec3T<F> w) const { return x * w.x + y * w.y + z * w.z; }
  Vec3T<F> toLocal(Vec3T<F> w) const { return {dot(w, x), dot(w, y), dot(w, z)}; }

  Vec3T<F> x, y, z;
};

}  // namespace saccade
