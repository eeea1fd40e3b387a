#include "filter/anti_firefly.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace saccade {
namespace {

// Whether a frame shows one surface at both pixels: the tolerances are those of SameSurface.
bool oneSurface(const GBuffer& g, int x, int y, int u, int v) {
  const float z = g.z.at(x, y), tolerance = 10 * g.dz.at(x, y) + 0.02f * z;
  const float cosine =
      g.nx.at(x, y) * g.nx.at(u, v) + g.ny.at(x, y) * g.ny.at(u, v) + g.nz.at(x, y) * g.nz.at(u, v);
  return cosine >= 0.9f && std::abs(g.z.at(u, v) - z) <= tolerance;
}

struct Ranks {
  void add(float v) { low = std::min(low, v), high = std::max(high, v); }
  float select(float v) const { return low <= high ? std::clamp(v, low, high) : v; }
  float low = std::numeric_limits<float>::infinity(), high = -low;
};

}  // namespace

std::chrono::nanoseconds removeFireflies(const FramePair& frames, const FilterPlanes& in,
                                         const PoolHandle& pool, FilterPlanes& out) {
  const int width = in.i.width();
  return pool.forEachRow(in.i.height(), [&](int y) {
    for (int x = 0; x < width; ++x) {
      Ranks primal, difference;
      for (int k = 0; k < 9; ++k) {
        const int u = x + k % 3 - 1, v = y + k / 3 - 1;  // outside the picture normals are 0
        if (k == 4 || !oneSurface(frames.cur.g, x, y, u, v)) continue;
        primal.add(in.i.at(u, v));
        if (oneSurface(frames.prev.g, x, y, u, v)) difference.add(in.d.at(u, v));
      }
      out.i.at(x, y) = primal.select(in.i.at(x, y));
      out.d.at(x, y) = difference.select(in.d.at(x, y));
    }
    std::copy_n(in.var_i.row(y), width, out.var_i.row(y));
    std::copy_n(in.var_d.row(y), width, out.var_d.row(y));
  });
}

}  // namespace saccade
