// Shapes at one time: those that stand, and then the bodies. A scene without bodies pays one comparison for a
// packet of rays.
#pragma once

#include "render/world/embree_instances.h"

namespace saccade {

class PosedShapes {
 public:
  using Rays = EmbreeTracer::Rays;

  // `bodies`: nullptr where there are none.
  PosedShapes(const EmbreeScene& still, const EmbreeInstances* bodies) : still_(still), bodies_(bodies) {}

  const EmbreeScene& still() const { return still_; }
  const EmbreeInstances* bodies() const { return bodies_; }

  // See EmbreeTracer.
  Hit intersect(const Ray& ray) const {
    Hit hit = still_.intersect(ray);
    if (bodies_) bodies_->intersect({ray.origin, ray.direction, hit.valid ? hit.t : ray.tfar}, hit);
    return hit;
  }
  bool occluded(const Ray& ray) const { return still_.occluded(ray) || (bodies_ && bodies_->occluded(ray)); }
  template <int W>
  void intersect(RayPacket<W>& packet, LaneSet lanes, Rays rays) const {
    still_.intersect(packet, lanes, rays);
    if (bodies_) bodies_->intersectFurther(packet, lanes, rays);
  }
  template <int W>
  void occluded(RayPacket<W>& packet, LaneSet lanes) const {
    still_.occluded(packet, lanes);
    if (!bodies_) return;
    LaneSet open;
    forEachLane(lanes, [&](int i) { open.add(i, packet.far[i] >= 0); });
    if (open.any()) bodies_->occluded(packet, open);
  }

 private:
  const EmbreeScene& still_;
  const EmbreeInstances* bodies_;
};

}  // namespace saccade
