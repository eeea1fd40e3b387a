// Light that was computed ahead: what a grid has learned, blended once at each of its vertices. It never
// changes, so that any number of feeds can share it, and reading it is cheap [ours].
//
// takes    the levels of a grid that has learned
// returns  illumination at points whose surroundings the grid knows, and its variance
#pragma once

#include "cache/bake/baked_blend.h"
#include "cache/bake/baked_levels.h"
#include "cache/grid/surface_grid.h"
#include "frame/point_samples.h"

namespace saccade {

class BakedLight {
 public:
  BakedLight(const GridLevels& grid, const GridParams& params, const PoolHandle& pool);

  // Reads at the points of a tile, and marks those of pixels all of whose light is known as baked. Sets these
  // pixels to the sum over their points, by shares, and clears all others of the tile. Points at the edge of
  // a shadow are marked as near_shadow, and want rays where the edge is visible.
  void read(Tile tile, SurfaceSamples& on, const GBuffer& g, GridEstimate& out) const;

  struct Pixel {
    int x, y;
  };
  // Shadows by rays, of the points of a frame.
  struct FrameShadows {
    const std::vector<SurfaceShadow>* all = nullptr;  // nullptr: there are none
    RayVisibility SurfaceShadow::*visibility = &SurfaceShadow::now;
  };
  // Sets pixels that are baked again, with the visibility that rays tell where they were wanted. The same
  // points with the same rays give the same bits.
  void readAgain(std::span<const Pixel> pixels, const SurfaceSamples& on, const GBuffer& g,
                 const FrameShadows& shadows, GridEstimate& out) const;
  // Reads at points of any pixels and times, those of kNone apart. Neighbours should follow each other. As
  // many as there are of `out`. A point of a frame gets the same bits.
  void read(std::span<const PointSample> at, std::span<PlaceLight> out) const;

  std::size_t vertices() const { return vertices_; }  // whose light is known

 private:
  void forEachBatch(const auto& forEachPoint, const auto& each) const;

  GridParams params_;
  float scale_;  // of the residual that vertices keep
  BakedLevels levels_;
  std::size_t vertices_ = 0;
};

}  // namespace saccade
