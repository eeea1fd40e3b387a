// Light on surfaces, kept in the world: a grid of several resolutions that every frame adds its samples to.
//
// takes    samples of frames, each at its surface point
// returns  illumination at any point that is placed in the grid, and its variance
//
// Work on a frame begins with place(). The result of add() goes to readAdded(), and its result to learn().
// Other frames are read in between.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <span>

#include "base/pool_handle.h"
#include "cache/grid/evidence.h"
#include "cache/grid/new_vertices.h"
#include "frame/frame.h"
#include "frame/obstacles.h"
#include "frame/point_samples.h"

namespace saccade {

struct GridParams {
  float cell_px = 1.4f;  // edge of the finest cells, pixels
  BlendParams blend{.tau = 1, .noise = 0.23f, .noise_weight = 3};
  std::size_t max_vertices = 2'000'000;  // above it, the least recently used are evicted
  // Of cells of about two pixels.
  int pixelSlot() const;
};

// The grid's estimate for each pixel: the sum over its points, by their shares. Planes of the size of the
// frame.
struct GridEstimate {
  GridEstimate(int w, int h) : i(w, h), var_i(w, h), var_step(w, h) {}
  ImageF i;         // illumination, 0 where no point is in the grid
  ImageF var_i;     // its variance
  ImageF var_step;  // the variance of its change from here to where the pixel's motion vector points

  void clear(Tile tile) {
    for (int y = tile.y0; y < tile.y1; ++y)
      for (ImageF* plane : {&i, &var_i, &var_step})
        std::fill(plane->row(y) + tile.x0, plane->row(y) + tile.x1, 0.f);
  }
};

// A frame, and the vertices around its points.
struct FrameOnGrid {
  const SurfaceSamples& on;
  const GBuffer& g;
  const Placement& at;
  // Visibility by rays at its points, of SurfaceSamples::shadows; nullptr: there is none.
  const std::vector<SurfaceShadow>* shadows = nullptr;
  RayVisibility SurfaceShadow::*visibility = &SurfaceShadow::now;
  // Residual light to add, by point, instead of SurfaceSamples::light; nullptr: none.
  const std::vector<float>* residuals = nullptr;
};

class SurfaceGrid {
 public:
  using Time = std::chrono::nanoseconds;  // CPU time, over all threads
  static constexpr float kUnknown = 1e18f;
  static constexpr std::size_t kBytesPerVertex = 128;

  explicit SurfaceGrid(const GridParams& params) : params_(params) {}

  // Finds the vertices around the points of a frame, and adds those that are missing. Vertices do not reach
  // through `obstacles`; nullptr: there are none. The frame before it is at `prev`, and stays valid: where
  // the grid has become too large, it drops vertices that neither of them uses.
  Time place(const SurfaceSamples& on, const Obstacles* obstacles, const PoolHandle& pool, Placement& prev,
             Placement& out);
  // Relative standard deviation of the mean over a cell of about two pixels at the points of a frame. It does
  // not matter whether its detail is believed. It is kUnknown where nothing is known yet, and 0 where there
  // is no point. `out` has the columns of `on`.
  // `shadow_detail`: the variance of visibility within the finest cells where rays are to tell it, otherwise
  // 0. Its noise then counts as none. nullptr: rays tell it nowhere.
  Time uncertainty(const FrameOnGrid& frame, const PoolHandle& pool, ImageF& out,
                   ImageF* shadow_detail = nullptr) const;
  // Standard deviation of the mean change over a cell of about two pixels, relative to the light there. It is
  // that at the points of a frame, and 0 where nothing is known. `changes`: a grid of changes that does
  // follow() this one. `out` has the columns of SurfaceSamples.
  Time errorOfChange(const FrameOnGrid& frame, const SurfaceGrid& changes, const PoolHandle& pool,
                     ImageF& out) const;
  // The steps that a frame has gone through.
  struct Added {
    FrameOnGrid frame;
    Time time;
  };
  struct Compared {
    const Placement& at;
    Time time;
  };
  // Takes the vertices of another grid, instead of place(): the Placement is that of the other one. Forgets
  // all where that has dropped some.
  void follow(const SurfaceGrid& other);
  // Keeps the share kept(point), in [0, 1], of what is known around the points of a frame. Call it before
  // add().
  using Kept = float (*)(const SurfacePoint&);
  Time fade(const FrameOnGrid& frame, Kept kept, const PoolHandle& pool);
  // Changes the residual light that is known around the points of a frame, by `change` of their pixels. A
  // vertex takes the mean change of its points.
  Time moveOn(const FrameOnGrid& frame, const ImageF& change, const PoolHandle& pool);
  // Adds a frame's samples.
  Added add(const FrameOnGrid& frame, const PoolHandle& pool);
  // Reads at the points of a frame, and sets the pixels that show any.
  Time read(const FrameOnGrid& frame, const PoolHandle& pool, GridEstimate& out) const;
  // The same for the frame that was added last. Compares its samples with the estimate by all others there.
  Compared readAdded(const Added& added, const PoolHandle& pool, GridEstimate& out);
  // Learns from that comparison which levels to believe.
  Time learn(const Compared& compared, const PoolHandle& pool);
  // Reads again, but only where uncertainty() of either frame was kUnknown.
  Time readAgain(const FrameOnGrid& frame, const PoolHandle& pool, const ImageF& uncertainty,
                 const ImageF& uncertainty_prev, GridEstimate& out) const;
  // Reads at points of any pixels and times: those that have a kind, and that `out` does not know yet. There
  // are as many of `out`. It knows points that any sample is near to, and adds no vertices.
  void readPoints(std::span<const PointSample> at, std::span<PlaceLight> out) const;
  // Forgets all light: it has changed.
  void forget();
  // Changes GridParams::max_vertices.
  void limit(std::size_t max_vertices) { params_.max_vertices = max_vertices; }

  // Its state. A grid given another's levels continues identically.
  const GridLevels& levels() const { return levels_; }
  GridLevels& levels() { return levels_; }
  std::size_t vertices() const;
  std::uint64_t dropped() const { return dropped_; }  // vertices, so far

 private:
  void drop(Placement& prev);
  void findVertices(int l, Placement& out);
  Time cutAtWalls(const SurfaceSamples& on, const Obstacles* obstacles, const PoolHandle& pool,
                  Placement& out);
  void prefetch(const Placement& at, const GridPoint& p) const;
  Time readBands(const FrameOnGrid& frame, const PoolHandle& pool, const auto& wanted, const auto& each,
                 GridEstimate& out) const;

  GridParams params_;
  GridLevels levels_;
  std::uint32_t now_ = 0;  // frames placed so far
  std::uint64_t dropped_ = 0;
  std::vector<NewVertices> new_;    // of the frame, from its least level on
  std::vector<Quad> samples_;       // of the frame, by point, as GridLevel::light adds them up
  std::vector<Evidence> evidence_;  // of them
};

}  // namespace saccade
