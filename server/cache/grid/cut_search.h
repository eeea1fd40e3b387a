// Finds the walls that cut the surroundings of new vertices.
#pragma once

#include "cache/grid/grid_levels.h"
#include "cache/grid/new_vertices.h"
#include "frame/obstacles.h"
#include "frame/surface_samples.h"

namespace saccade {

class CutSearch {
 public:
  // Of the vertices that a frame has added. `obstacles`: nullptr where there are none.
  CutSearch(const SurfaceSamples& on, const Obstacles* obstacles, const Placement& at, GridLevels& levels,
            std::uint32_t now)
      : on_(on), obstacles_(obstacles), at_(at), levels_(levels), now_(now) {}
  // Cuts those of one level. Coarser levels come first.
  void cut(int l, const NewVertices& added);

 private:
  // The planes of a cut have the point in front, and pass near a vertex at `place`. `h`: edge of a cell. New
  // planes stand at the nearest obstacles with a surface of the point's normal behind. Inherited ones are the
  // nearest of the next coarser level.
  CutPlanes probe(const GridPoint& p, Vec3 place, float h) const;
  CutPlanes inherit(const GridPoint& p, int slot, Vec3 place, float h) const;
  bool isWall(const Obstacles::ProbeRay& ray, const Obstacle& met, Vec3 n, float h) const;
  bool isAbove(const Obstacles::ProbeRay& ray, const Obstacle& met, Vec3 n, float h) const;
  bool isBeside(const Obstacles::ProbeRay& ray, const Obstacle& met, Vec3 n, float h) const;
  // Calls f(plane) for each plane of the next coarser level around the point.
  void forEachCoarser(const GridPoint& p, int slot, const auto& f) const;

  const SurfaceSamples& on_;
  const Obstacles* obstacles_;
  const Placement& at_;
  GridLevels& levels_;
  std::uint32_t now_;
};

// Moves the taps of new vertices to the side of the cut on which their point lies.
void remapTaps(const GridLevel& level, int l, const NewVertices& found, Placement& at);

}  // namespace saccade
