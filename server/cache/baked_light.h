// Light that was computed ahead: what a grid has learned, blended once at each of its vertices. It never
// changes, so that any number of feeds can share it, and reading it is cheap [ours].
//
// takes    the levels of a grid that has learned
// returns  illumination at points whose surroundings the grid knows, and its variance
#pragma once

#include "cache/baked_blend.h"
#include "cache/surface_grid.h"

namespace saccade {

class BakedLight {
 public:
  using Time = SurfaceGrid::Time;

  BakedLight(const GridLevels& grid, const GridParams& params, const PoolHandle& pool);

  // Reads at the points of a frame, and marks those whose light is known as baked. `out` has the sum over
  // them, by their shares.
  Time read(SurfaceSamples& on, const GBuffer& g, const PoolHandle& pool, GridEstimate& out) const;
  std::size_t vertices() const { return vertices_; }  // whose light is known

 private:
  struct Tap {
    const Octet* light;
    float weight;
  };
  // The vertices around a point whose light is known.
  struct Taps {
    Octet sum() const;  // weighted
    std::array<Tap, 12> tap;
    int count = 0;
  };
  struct Found {
    GridPoint at;
    std::array<Taps, 2> slots;
  };
  class Finder;

  // Reads a point of pixel (x, y), and adds it to the pixel.
  void add(const Found& found, SurfacePoint& point, const GBuffer& g, int x, int y, GridEstimate& out) const;

  GridParams params_;
  int first_ = 0;                   // the exponent of the finest level
  std::vector<BakedLevel> levels_;  // from fine to coarse
  std::size_t vertices_ = 0;
};

}  // namespace saccade
