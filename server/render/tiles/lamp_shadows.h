// The share of the light of lamps in closed form that nothing blocks, by shadow rays at the points of two frames.
//
// Both frames' points ask for the same points of the lamps, so that the change is that of the shadow. Points get
// few rays at first. Where some of the neighbours' rays are blocked and others not, as in a penumbra, they get
// many.
#pragma once

#include <chrono>
#include <vector>

#include "base/pool_handle.h"
#include "frame/frame.h"
#include "render/camera/pixel_context.h"
#include "render/tiles/surface_start.h"

namespace saccade {

// The surfaces of a frame, and where paths start from them.
struct FrameStarts {
  const PosedScene& scene;
  const Frame& frame;
  const SurfaceStarts& starts;
};

class LampShadows {
 public:
  // Fills SurfaceSamples::shadows of `now`, where its `wanted` asks. `before`: the frame before it. Returns the
  // CPU time.
  std::chrono::nanoseconds trace(const FrameStarts& now, const FrameStarts& before, const PoolHandle& pool,
                                 std::vector<SurfaceShadow>& out);
  // A new frame begins: that of the last trace() is now the one before.
  void next(std::size_t points);

 private:
  // What the rays of a point have found, and their number so far.
  struct Traced {
    float visible = 0, all = 0;  // weights
    int rays = 0;
    bool isWhole() const { return visible == 0 || visible == all; }
    float visibility() const { return all > 0 ? visible / all : 1; }
  };
  template <Shading S>
  void traceTile(const FrameStarts& of, Tile tile, int rays, const auto& wanted, std::vector<Traced>& traced);
  bool isPenumbra(const SurfaceSamples& on, int column, int y) const;
  SurfaceShadow shadowOf(std::size_t index, float left_out) const;

  std::vector<Traced> now_, before_;  // by point
};

}  // namespace saccade
