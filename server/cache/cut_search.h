// Finds the walls that cut the surroundings of new vertices.
#pragma once

#include "cache/grid_levels.h"
#include "cache/new_vertices.h"
#include "frame/surface_samples.h"

namespace saccade {

class CutSearch {
 public:
  // Of the vertices that a frame has added.
  CutSearch(const SurfaceSamples& on, const Placement& at, GridLevels& levels, std::uint32_t now)
      : on_(on), at_(at), levels_(levels), now_(now) {}
  // Of one level. Coarser ones come first.
  void cut(int l, const NewVertices& added);

 private:
  // Planes through what lies around a vertex at `place`, with the point in front. `h`: edge of a cell. Of the
  // nearest obstacles that have a surface of the point's normal behind them:
  CutPlanes probe(const GridPoint& p, Vec3 place, float h) const;
  bool isWall(const Obstacles::Way& way, const Obstacle& met, Vec3 n, float h) const;
  bool isAbove(const Obstacles::Way& way, const Obstacle& met, Vec3 n, float h) const;
  bool isBeside(const Obstacles::Way& way, const Obstacle& met, Vec3 n, float h) const;
  // the nearest of the level above:
  CutPlanes inherit(const GridPoint& p, int slot, Vec3 place, float h) const;
  // f(plane) for all of those.
  void forEachCoarser(const GridPoint& p, int slot, const auto& f) const;

  const SurfaceSamples& on_;
  const Placement& at_;
  GridLevels& levels_;
  std::uint32_t now_;
};

// Leads the taps that have new vertices around their cuts.
void leadAround(const GridLevel& level, int l, const NewVertices& found, Placement& at);

}  // namespace saccade
