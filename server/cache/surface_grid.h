// Light on surfaces, kept in the world: a grid of several resolutions that every frame adds its samples to.
//
// takes    samples of frames, each at its surface point
// returns  illumination at any point that is placed in the grid, and its variance
#pragma once

#include <array>
#include <chrono>
#include <memory>

#include "base/pool_handle.h"
#include "cache/placement.h"
#include "cache/vertex_table.h"

namespace saccade {

struct GridParams {
  float finest_px = 0.5f;  // edge of the finest cells, pixels
  float tau = 1;           // standard deviations that a level's detail must exceed its noise by
  float noise = 0.23f;     // variance of an interpolated mean, of that of one sample, at a density of one
};

// What the grid says at each pixel. Planes of the size of the frame.
struct GridEstimate {
  GridEstimate(int w, int h) : i(w, h), var_i(w, h), var_step(w, h), uncertainty(w, h) {}
  static constexpr float kUnknown = 1e9f;
  ImageF i;            // illumination, 0 where the pixel is not in the grid
  ImageF var_i;        // its variance
  ImageF var_step;     // the variance of its change from here to where the pixel's motion vector points
  ImageF uncertainty;  // standard deviation of the mean over a cell of about a pixel, or kUnknown
};

class SurfaceGrid {
 public:
  using Time = std::chrono::nanoseconds;  // CPU time, over all threads

  explicit SurfaceGrid(const GridParams& params) : params_(params) {}

  // Finds the vertices around the points of a frame, and adds those that are missing.
  Time place(const SurfaceSamples& on, const GBuffer& g, const PoolHandle& pool, Placement& out);
  // Forgets all light: it has changed.
  void forget();
  // Adds a frame's samples, which `at` has placed.
  Time add(const SurfaceSamples& on, const Placement& at, const PoolHandle& pool);
  // Reads at the points of a frame.
  Time read(const SurfaceSamples& on, const GBuffer& g, const Placement& at, const PoolHandle& pool,
            GridEstimate& out) const;
  // The same for the frame that was added last. Compares its samples with what all others say there.
  Time readAdded(const SurfaceSamples& on, const GBuffer& g, const Placement& at, const PoolHandle& pool,
                 GridEstimate& out);
  // Learns from that comparison which levels to believe.
  Time learn(const Placement& at, const PoolHandle& pool);
  std::size_t vertices() const;

  using Quad = float __attribute__((vector_size(16)));
  using Octet = float __attribute__((vector_size(32)));

 private:
  struct Level {
    VertexTable table;
    std::vector<Quad> light;      // sums of 1, rest, visible / U, unoccluded / U (samples)
    std::vector<Octet> evidence;  // sums for rest, then for visibility, see surface_grid.cpp
  };
  struct Chain;
  struct Finding {  // what a pixel's sample says of each level's detail
    std::array<float, kGridLevels - 1> rest, visibility;
    float residual_rest, residual_visibility;
    float paths, unoccluded;  // the weights of both
  };

  Level& level(int l) { return *levels_[l - kLeastLevel]; }
  const Level& level(int l) const { return *levels_[l - kLeastLevel]; }
  template <class Each>  // of each point: each(its chain, its pixel)
  Time forEachPoint(const SurfaceSamples& on, const GBuffer& g, const Placement& at, const PoolHandle& pool,
                    GridEstimate& out, const Each& each) const;
  void prefetch(const Placement& at, const GridPoint& p) const;
  void findVertices(const SurfaceSamples& on, int l, Placement& out);
  void addLight(const Placement& at, int l);
  void addEvidence(const Placement& at, int l);
  Finding compare(const Chain& chain, const Placement& at, std::size_t pixel) const;

  static constexpr int kLeastLevel = -64, kMostLevel = 63;
  GridParams params_;
  std::array<std::unique_ptr<Level>, kMostLevel - kLeastLevel + 1> levels_;
  std::vector<Quad> samples_;  // of the frame, by pixel, as Level::light adds them up
  std::vector<Finding> findings_;
};

}  // namespace saccade
