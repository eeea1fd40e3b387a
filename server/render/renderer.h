// Renders frames: features, and the samples of both passes.
#pragma once

#include <chrono>
#include <functional>
#include <memory>

#include "base/pool_handle.h"
#include "cache/grid/bounce_grid.h"
#include "frame/frame.h"
#include "frame/seed_plan.h"
#include "frame/surface_frame.h"
#include "render/camera/camera.h"
#include "render/tiles/surface_start.h"
#include "render/world/render_scene.h"
#include "scene/emitter_strengths.h"

namespace saccade {

struct RenderSettings {
  int bounces = 3;      // indirect
  int channels = 3;     // 1 or 3
  bool jitter = false;  // paths start at points all over the pixel (paper, Fig. 12)
};

class Renderer {
 public:
  using OnTile = std::function<void(Tile)>;

  // Shares `scene`.
  Renderer(std::shared_ptr<const RenderScene> scene, RenderSettings settings)
      : scene_(std::move(scene)), strengths_(scene_->description()), settings_(settings) {}

  // Fills out.g and out.samples. Emitters have their strength at out.time. Returns the CPU time. The picture
  // depends on the arguments alone.
  std::chrono::nanoseconds render(const Camera& camera, const Camera& prev, const SeedPlan& seeds,
                                  const PoolHandle& pool, Frame& out);

  // The same for frames with SurfaceSamples, in two steps. First features, and the surfaces that samples are
  // of; then as many paths as SurfacePoint::paths says, of pass 2 alone. `on_tile` is called with each tile
  // as soon as it is known. It may mark points as baked: they get paths only if their pixel hasUncacheable().
  // `known`: light that ends paths at their second vertex; nullptr: there is none. Where no point needs
  // paths, the second step copies what the picture emits.
  SurfaceFrame renderSurfaces(
      const Camera& camera, const Camera& prev, const PoolHandle& pool, Frame& out,
      const OnTile& on_tile = [](Tile) {});
  std::chrono::nanoseconds renderPaths(const Camera& camera, const SeedPlan& seeds, const SurfaceFrame& next,
                                       const BounceGrid* known, const PoolHandle& pool);

  // Renders one picture in colour at out.time, into three planes. All of the `spp` paths per pixel start at
  // its centre. Features go to `out.g`; `out.samples` does not change.
  void renderStill(const Camera& camera, std::uint64_t seed, int spp, const PoolHandle& pool, Frame& out,
                   ImageF (&rgb)[3]);

 private:
  std::shared_ptr<const RenderScene> scene_;
  EmitterStrengths strengths_;  // at the time of the current frame
  RenderSettings settings_;
  SurfaceStarts starts_;  // of renderSurfaces(), of points that may get paths
};

}  // namespace saccade
