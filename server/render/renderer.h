// Renders frames: features, and the samples of both passes.
#pragma once

#include <chrono>
#include <functional>

#include "base/pool_handle.h"
#include "cache/grid/bounce_grid.h"
#include "frame/frame.h"
#include "frame/seed_plan.h"
#include "frame/surface_frame.h"
#include "render/camera/pixel_context.h"
#include "render/tiles/surface_start.h"

namespace saccade {

struct RenderSettings {
  int bounces = 3;      // indirect
  int channels = 3;     // 1 or 3
  bool jitter = false;  // paths start at points all over the pixel (paper, Fig. 12)
};

class Renderer {
 public:
  using OnTile = std::function<void(Tile)>;

  explicit Renderer(RenderSettings settings) : settings_(settings) {}

  // Fills out.g and out.samples. Returns the CPU time. The picture depends on the arguments alone.
  std::chrono::nanoseconds render(const PixelContext& view, const SeedPlan& seeds, const PoolHandle& pool,
                                  Frame& out);

  // The same for frames with SurfaceSamples, in two steps. First features, and the surfaces that samples are
  // of; then as many paths as SurfacePoint::paths says, of pass 2 alone. `on_tile` is called with each tile
  // as soon as it is known. It may mark points as baked: they get paths only if their pixel hasUncacheable().
  // `known`: light that ends paths at their second vertex; nullptr: there is none. Where no point needs
  // paths, the second step copies what the picture emits.
  SurfaceFrame renderSurfaces(
      const PixelContext& view, const PoolHandle& pool, Frame& out, const OnTile& on_tile = [](Tile) {});
  std::chrono::nanoseconds renderPaths(const PosedView& view, const SeedPlan& seeds, const SurfaceFrame& next,
                                       const BounceGrid* known, const PoolHandle& pool);

  // Renders one picture in colour, into three planes. The paths of a pixel, those of pass 2, all start at
  // its centre. Features go to `out.g`; `out.samples` does not change.
  void renderStill(const PixelContext& view, const SeedPlan& seeds, const PoolHandle& pool, Frame& out,
                   ImageF (&rgb)[3]);

 private:
  RenderSettings settings_;
  SurfaceStarts starts_;  // of renderSurfaces(), of points that may get paths
};

}  // namespace saccade
