// Light that was computed ahead: what a grid has learned, blended once at each of its vertices. It never
// changes, so that any number of feeds can share it, and reading it is cheap [ours].
//
// takes    the levels of a grid, when it has learned
// returns  illumination at points whose surroundings the grid knows, and its variance
#pragma once

#include "cache/surface_grid.h"

namespace saccade {

class BakedLight {
 public:
  using Time = SurfaceGrid::Time;

  BakedLight(GridLevels grid, const GridParams& params, const PoolHandle& pool);

  // Reads at the points of a frame. Where the light is known, `known` is 1 and `out` has it. Elsewhere all
  // of them are 0.
  Time read(const SurfaceSamples& on, const GBuffer& g, const PoolHandle& pool, GridEstimate& out,
            Image<std::uint32_t>& known) const;
  std::size_t vertices() const { return vertices_; }  // whose light is known

 private:
  // The light at a vertex that is the finest around: 1, rest, visibility, their variances, and those of a
  // step over the length of a cell if they went on growing with its square. All are 0 where it is not known.
  enum Lane { kKnown, kRest, kVisibility, kVarRest, kVarVisibility, kStepRest, kStepVisibility };
  struct Level {
    VertexTable table;
    std::vector<Octet> light;  // by vertex
  };
  class Readers;

  bool readPixel(const SurfaceSamples& on, const GBuffer& g, int x, int y, Readers& readers,
                 GridEstimate& out) const;
  Octet lightAt(const GridPoint& p, const NormalBins& normal, int slot, Readers& readers) const;

  GridParams params_;
  int first_ = 0;              // the exponent of the finest level
  std::vector<Level> levels_;  // from fine to coarse
  std::size_t vertices_ = 0;
};

}  // namespace saccade
