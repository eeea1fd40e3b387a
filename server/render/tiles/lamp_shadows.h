// Visibility of the lamps in closed form, by shadow rays at the points of two frames [ours].
//
// A point asks for the same points of the lamps in all frames, so that a change of visibility is that of the
// shadow. It gets few rays at first. Where some of those of its neighbours are blocked and others are not, as
// in a penumbra, it gets many.
#pragma once

#include <array>
#include <chrono>
#include <vector>

#include "base/pool_handle.h"
#include "render/tiles/lamp_rays.h"

namespace saccade {

// Why a point needs many rays: its visibility is all that is not known ahead, or may be unlike that before.
enum RayNeed : std::size_t { kElseLearned, kElseKnown, kMayHaveMoved };

class LampShadows {
 public:
  // Of a penumbra, to a group of lamps.
  static int raysOf(RayNeed need, int spp);

  // A frame with so many points begins: the rays of the last one are now those of the frame before.
  void next(const RenderScene& scene, std::size_t points);

  // Fills the shadows that are wanted. The rays of penumbras are in proportion to `spp`. Returns the CPU
  // time.
  std::chrono::nanoseconds trace(const FrameStarts& now, const FrameStarts& before, int spp,
                                 const PoolHandle& pool, std::vector<SurfaceShadow>& shadows);
  const FrameRays& rays() const { return now_; }  // of the frame that began last

 private:
  // Of a band of rows.
  struct Requests {
    std::vector<RayRequest> few;
    std::array<std::vector<RayRequest>, 3> many;  // by RayNeed
  };
  // Returns the groups of a request of which some rays arrive and others do not, in both frames together.
  std::uint32_t groupsThatDiffer(const RayRequest& request) const;
  void finish(std::size_t point, int rays, SurfaceShadow& shadow) const;

  FrameRays now_, before_;
  std::vector<Requests> bands_;
};

}  // namespace saccade
