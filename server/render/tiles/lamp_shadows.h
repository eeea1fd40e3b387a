// Visibility of the lamps in closed form, by shadow rays at the points of two frames [ours].
//
// A point asks for the same points of the lamps in all frames, so that a change of visibility is that of the
// shadow. It gets few rays at first. Where some of those of its neighbours are blocked and others are not, as
// in a penumbra, it gets many.
#pragma once

#include <chrono>
#include <vector>

#include "base/pool_handle.h"
#include "frame/frame.h"
#include "render/tiles/surface_start.h"
#include "render/world/posed_scene.h"

namespace saccade {

// The surfaces of a frame, and where paths start from them.
struct FrameStarts {
  const PosedScene& scene;
  const SurfaceSamples& on;
  const SurfaceStarts& starts;
};

class LampShadows {
 public:
  // A frame with so many points begins: the rays of the last one are now those of the frame before.
  void next(const RenderScene& scene, std::size_t points);

  // Fills the shadows that are wanted. The rays of penumbras are in proportion to `spp`. Returns the CPU
  // time.
  std::chrono::nanoseconds trace(const FrameStarts& now, const FrameStarts& before, int spp,
                                 const PoolHandle& pool, std::vector<SurfaceShadow>& shadows);

 private:
  // The rays of a point to one group of lamps.
  struct Rays {
    float visible = 0, all = 0;  // sums of weights
    float unoccluded = 0;        // light of the group
    int count = 0;
    bool areMixed() const { return visible > 0 && visible < all; }
    float visibility() const { return all > 0 ? visible / all : 1; }
  };
  // Of a frame, by point and group.
  struct Traced {
    FrameStarts of;
    std::vector<Rays>& rays;
  };
  template <Shading S>
  void traceTile(const Traced& frame, Tile tile, int count, const auto& wanted) const;
  bool isPenumbra(const Traced& frame, int column, int y, int group) const;
  void finish(std::size_t point, int rays, SurfaceShadow& shadow) const;
  std::size_t indexOf(std::size_t point, int group) const {
    return point * static_cast<std::size_t>(groups_) + static_cast<std::size_t>(group);
  }

  int groups_ = 0;
  std::vector<Rays> now_, before_;
  std::vector<char> penumbra_;  // by point and group
};

}  // namespace saccade
