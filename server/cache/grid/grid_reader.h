// Reads a grid at points of any pixels and times. It adds no vertices: those that are missing count as
// vertices without samples.
#pragma once

#include <span>
#include <vector>

#include "base/scratch.h"
#include "cache/grid/point_lanes.h"
#include "cache/grid/surface_grid.h"
#include "cache/lattice/tetrahedron_lanes.h"
#include "frame/point_samples.h"

namespace saccade {

class GridReader {
 public:
  // `levels` stay as they are.
  GridReader(const GridLevels& levels, const GridParams& params) : levels_(levels), params_(params) {}

  // The light at points that have a kind and that `out` does not know yet, where the grid has any samples.
  // As many as there are of `out`.
  void read(std::span<const PointSample> at, std::span<PlaceLight> out);

 private:
  bool hasLevels(const SurfacePlace& place) const;
  void findVertices(int slot);
  void setTaps(const TetrahedronLanes& lanes, int lane, const GridPoint& point, std::uint32_t t, int slot);
  void readLanes(const PointLanes& lanes, std::span<const PointSample> at, std::span<PlaceLight> out) const;

  const GridLevels& levels_;
  const GridParams params_;
  struct Memory {
    Placement at;
    std::vector<VertexTable::Reader> readers;  // by level, from the least of the placement on
  };
  const Scratch<Memory> memory_;
  Placement& at_ = memory_->at;
};

}  // namespace saccade
