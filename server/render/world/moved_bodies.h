// The bodies that lie elsewhere or have another form at another time of a scene, and the boxes around them at
// both times. A ray that meets no such box finds the same at both times [ours].
#pragma once

#include <vector>

#include "base/wide.h"
#include "render/world/posed_scene.h"
#include "scene/shape_box.h"

namespace saccade {

class MovedBodies {
 public:
  MovedBodies() = default;  // none
  // `before` stays as it is while rays are asked.
  MovedBodies(const PosedScene& now, const PosedScene& before);

  bool any() const { return any_; }
  bool includes(std::uint32_t body) const { return any() && body != kNoBody && moves_[body]; }
  // Whether all paths from a body, or from kNoBody, may find other light.
  bool touchAllFrom(std::uint32_t body) const { return lamps_move_ || includes(body); }
  // Around all that have shapes; of neighbours together where they are many.
  const std::vector<ShapeBox>& boxes() const { return boxes_; }

  // The lanes of a packet whose rays meet a box before they end.
  template <int W>
  [[gnu::always_inline]] LaneSet metBy(const RayPacket<W>& rays) const {
    LaneSet met;
    for (const ShapeBox& box : wide_boxes_) met |= lanesThat<W>(rays, box);
    return met;
  }
  // The lanes among `lanes` in which a body was in the way of the ray before it ends. Does not change `rays`.
  template <int W>
  [[gnu::always_inline]] LaneSet blockedBefore(RayPacket<W>& rays, LaneSet lanes) const {
    if (!lanes.any()) return {};
    const Floats<W> far = load<W>(rays.far);
    before_->all().template occluded<W>(rays, lanes);
    const LaneSet blocked = lanes & lanesOf(load<W>(rays.far) < 0.f);
    store(far, rays.far);
    return blocked;
  }

 private:
  template <int W>
  [[gnu::always_inline]] static LaneSet lanesThat(const RayPacket<W>& rays, const ShapeBox& box) {
    using F = Floats<W>;
    F first = 0.f, last = load<W>(rays.far);
    const auto clip = [&](const float* origin, const float* direction, float low, float high) {
      const F inverse = 1.f / load<W>(direction), start = load<W>(origin);
      const F a = (low - start) * inverse, b = (high - start) * inverse;
      first = max(first, min(a, b)), last = min(last, max(a, b));
    };
    clip(rays.origin_x, rays.x, box.low.x, box.high.x);
    clip(rays.origin_y, rays.y, box.low.y, box.high.y);
    clip(rays.origin_z, rays.z, box.low.z, box.high.z);
    return lanesOf(first <= last);
  }

  const PosedBodies* before_ = nullptr;
  std::vector<char> moves_;                   // by body
  std::vector<ShapeBox> boxes_, wide_boxes_;  // wide: with room for rounding
  bool any_ = false;
  bool lamps_move_ = false;  // whether one of them gives light
};

}  // namespace saccade
