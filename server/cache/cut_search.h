// Finds the walls that cut the surroundings of new vertices.
#pragma once

#include <optional>

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
  // A cut through what lies around a vertex at `place`, with the point in front; `other` is not set. `h`:
  // edge of a cell. From the nearest obstacle that has a surface of the point's normal behind it:
  std::optional<Cut> probe(const GridPoint& p, Vec3 place, float h) const;
  bool isAbove(const Obstacles::Way& way, const Obstacle& met, Vec3 n, float h) const;
  bool isBeside(const Obstacles::Way& way, const Obstacle& met, Vec3 n, float h) const;
  // from those of the level above:
  std::optional<Cut> inherit(const GridPoint& p, int slot, Vec3 place, float h) const;

  const SurfaceSamples& on_;
  const Placement& at_;
  GridLevels& levels_;
  std::uint32_t now_;
};

// Leads the taps that have new vertices around their cuts.
void leadAround(const GridLevel& level, int l, const NewVertices& found, Placement& at);

}  // namespace saccade
