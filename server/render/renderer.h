// Renders frames: features, and the samples of both passes.
#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <optional>

#include "base/pool_handle.h"
#include "cache/grid/bounce_grid.h"
#include "frame/frame.h"
#include "frame/seed_plan.h"
#include "frame/surface_frame.h"
#include "render/camera/pixel_context.h"
#include "render/tiles/lamp_shadows.h"
#include "render/tiles/surface_place.h"
#include "render/tiles/touched_paths.h"

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

  // Traces the shadow rays that SurfaceSamples::shadows of a frame ask for, at its points and at those of the
  // frame before. Called after renderPaths() of the frame.
  std::chrono::nanoseconds traceShadows(const PixelContext& view, int spp, Frame& now, const Frame& before,
                                        const PoolHandle& pool);

  // Sets or clears SurfaceSamples::changes() of a frame. Called after renderPaths(), whose numbers and light
  // it takes.
  std::chrono::nanoseconds renderReplays(const PixelContext& view, const SeedPlan& seeds,
                                         const PoolHandle& pool, Frame& out);

  // Replays the numbers of renderPaths() at the surfaces of the frame before, and adds pairs where they have
  // much noise. Sets out.pairs, and adds to out.samples.I2. `before`: the frame of the last but one
  // renderSurfaces(); both frames must have pixels that hasUncacheable().
  std::chrono::nanoseconds renderPairs(const PixelContext& view, const SeedPlan& seeds, const Frame& before,
                                       const BounceGrid* known, const PoolHandle& pool, Frame& out);

  // Renders one picture in colour, into three planes. The paths of a pixel, those of pass 2, all start at
  // its centre. Features go to `out.g`; `out.samples` does not change.
  void renderStill(const PixelContext& view, const SeedPlan& seeds, const PoolHandle& pool, Frame& out,
                   ImageF (&rgb)[3]);

  // From the frame before into that of the last renderSurfaces().
  const FrameRays& shadowRays() const { return shadows_.rays(); }  // after traceShadows()
  FrameMotion motion() const { return {moved_, *changing_, sliding_}; }
  // Of the last renderPaths() after which renderReplays() may replay any.
  const TouchedPaths& touchedPaths() const { return touched_; }

 private:
  RenderSettings settings_;
  SurfaceStarts& starts() { return starts_[current_]; }
  SurfaceStarts& startsBefore() { return starts_[1 - current_]; }

  // Of the last renderSurfaces().
  MovedBodies moved_;
  std::optional<ChangingLight> changing_;
  SlidingSurfaces sliding_;
  TouchedPaths touched_;
  // Of points that may get paths, of the last renderSurfaces(). Those of the one before it are kept where
  // its pixels hasUncacheable(), or where lamps have a closed form.
  std::array<SurfaceStarts, 2> starts_;
  std::size_t current_ = 0;
  LampShadows shadows_;
};

}  // namespace saccade
