// Light that moves: the grid forgets it, or changes it.
#include <algorithm>
#include <cmath>
#include <utility>

#include "cache/grid/grid_pieces.h"
#include "cache/grid/level_blend.h"
#include "cache/grid/surface_grid.h"

namespace saccade {

SurfaceGrid::Time SurfaceGrid::fade(const FrameOnGrid& frame, Kept kept, const PoolHandle& pool) {
  const Placement& at = frame.at;
  return forEachLevel(at, pool, [&](int l) {
    GridLevel& level = levels_[l];
    level.faded.resize(level.light.size());
    forEachPointOf(at, l, [&](std::size_t i, const GridPoint& p, int slot) {
      const float share = kept(frame.on[at.points[i].index]);
      if (share == 1) return;
      for (std::uint32_t t = p.first; t < p.first + p.count; ++t)
        for (const std::uint32_t v : at.taps[slot][t].vertex) {
          if (level.faded[v] == now_) continue;
          level.faded[v] = now_;
          level.light[v] *= share, level.evidence[v] *= share;
        }
    });
  });
}

SurfaceGrid::Time SurfaceGrid::moveOn(const FrameOnGrid& frame, const ImageF& change,
                                      const PoolHandle& pool) {
  const SurfaceSamples& on = frame.on;
  const Placement& at = frame.at;
  return forEachLevel(at, pool, [&](int l) {
    GridLevel& level = levels_[l];
    level.steps.resize(level.light.size());
    forEachPointOf(at, l, [&](std::size_t, const GridPoint& p, int slot) {
      if (slot > kTop) return;
      const float d = change.at(on.columnOf(p.index) / on.perPixel(), on.rowOf(p.index));
      scatter(MeanStep{1, d}, at, p, slot, level.steps, [](const MeanStep&) { return true; });
    });
    forEachPointOf(at, l, [&](std::size_t, const GridPoint& p, int slot) {
      for (std::uint32_t t = p.first; slot <= kTop && t < p.first + p.count; ++t)
        for (const std::uint32_t v : at.taps[slot][t].vertex) {
          const MeanStep step = std::exchange(level.steps[v], {});
          if (step.weight == 0) continue;
          Quad& light = level.light[v];
          light[1] = std::max(std::min(light[1], 0.f), light[1] + light[0] * step.sum / step.weight);
        }
    });
  });
}

SurfaceGrid::Time SurfaceGrid::errorOfChange(const FrameOnGrid& frame, const SurfaceGrid& changes,
                                             const PoolHandle& pool, ImageF& out) const {
  const SurfaceSamples& on = frame.on;
  const Placement& at = frame.at;
  const int slot = params_.pixelSlot(), pooled = slot + kPoolSteps;
  return forEachBand(on, pool, [&](int band, int y0, int y1) {
    for (int y = y0; y < y1; ++y) std::fill_n(out.row(y), out.width(), 0.f);
    const auto [first, end] = at.ofBand(band);
    for (std::size_t i = first; i < end; ++i) {
      const GridPoint& p = at.points[i];
      const Quad l = gather(levels_[p.level + slot].light, at, p, slot);
      const Quad change = gather(changes.levels_[p.level + slot].light, at, p, slot);
      const Octet e = gather(changes.levels_[p.level + pooled].evidence, at, p, pooled);
      const float direct = l[3] > 0 ? on.place(p.index).unoccluded * l[2] / l[3] : 0;
      const float light = l[0] > 0 ? l[1] / l[0] + direct : 0;
      const float variance = varianceOf<float>(e[2], e[3], change[0], params_.blend);
      if (light > 0) out.at(on.columnOf(p.index), on.rowOf(p.index)) = std::sqrt(variance) / light;
    }
  });
}

}  // namespace saccade
