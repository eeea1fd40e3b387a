#include "filter/motion_alignment.h"

#include <cmath>

#include "filter/reprojection.h"
#include "filter/surface_test.h"
#include "frame/pixel_before.h"

namespace saccade {

std::chrono::nanoseconds alignDifference(const FramePair& frames, Demodulation by, const PoolHandle& pool,
                                         ImageF& d) {
  const Frame &now = frames.cur, &before = frames.prev;
  const auto light = [&](const GBuffer& g, PixelPlace p, const ImageF& I) {
    return (I.at(p.x, p.y) - g.emission.at(p.x, p.y)) / filterAlbedo(g.albedo.at(p.x, p.y), by);
  };
  return pool.forEachRow(d.height(), [&](int y) {
    for (int x = 0; x < d.width(); ++x) {
      const PixelPlace p = pixelBefore(now.g, x, y);
      const float difference = light(now.g, {x, y}, now.samples.I1) - light(before.g, p, before.samples.I2);
      const bool same = SameSurface(now.g, before.g, x, y)(p.y * before.g.z.stride() + p.x);
      const bool sound = std::abs(difference) <= 1e18f;  // as in demodulate()
      d.at(x, y) = same && sound && !frames.is_first ? difference : 0;
    }
  });
}

std::chrono::nanoseconds correctAlignment(const FramePair& frames, const ImageF& i_prev,
                                          const PoolHandle& pool, FilterPlanes& filtered) {
  const GBuffer &g = frames.cur.g, &g_prev = frames.prev.g;
  return pool.forEachRow(i_prev.height(), [&](int y) {
    for (int x = 0; x < i_prev.width(); ++x) {
      const Reprojection W = Reprojection::find(g, g_prev, x, y, SameSurface(g, g_prev, x, y));
      const float then = W.found() ? W(i_prev) : filtered.i.at(x, y);
      float& d = filtered.d.at(x, y);
      d = (W.found() ? d : 0) + (then - i_prev.at(x, y));
    }
  });
}

}  // namespace saccade
