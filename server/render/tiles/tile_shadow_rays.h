// Shadow rays from the points of a tile, traced in packets.
#pragma once

#include "render/paths/surface_stages.h"
#include "render/world/ray_packet.h"

namespace saccade {

struct ShadowRay {
  Vec3 origin, segment;
  float reach;            // its end, in lengths of the segment
  std::uint32_t owner;    // who asks
  float weight = 1;       // of its light
  std::uint32_t bit = 0;  // see RayBits
};

// The light that comes straight through panes and masks.
template <Shading S>
class StraightLight {
 public:
  explicit StraightLight(const Tracing& t) : t_(t) {}

  bool has() const { return has_panes_; }  // whether the scene has any panes or masks
  // Of the shapes that stop a ray.
  std::uint32_t stops() const { return has_panes_ ? kBlockingMask : kBlockingMask | kStraightMask; }
  // The fraction that arrives along a ray that nothing stops.
  Rgb along(const Ray& ray) const {
    if (!has_panes_) return {1, 1, 1};
    const Hit hit = t_.scene.straight().intersect(ray);
    return hit.valid ? transmit_(t_, ray, hit).fraction : Rgb{1, 1, 1};
  }

 private:
  const Tracing& t_;
  const bool has_panes_ = S.extras && t_.scene.still().hasStraightTransmission();
  const decltype(SurfaceStages<1>::transmit) transmit_ = surfaceStages<S, 1, true>().transmit;
};

// Calls on_end(ray, fraction) for each ray, in the order in which they were added. The fraction is that of
// light which arrives: 0 behind a surface, less than 1 behind panes and masks.
template <Shading S, class OnEnd>
class TileShadowRays {
 public:
  TileShadowRays(const Tracing& t, const OnEnd& on_end) : t_(t), on_end_(on_end), straight_(t) {}

  void add(const ShadowRay& ray) {
    rays_[count_] = ray;
    packet_.set(count_++, {ray.origin, ray.segment, ray.reach});
    if (count_ == kRays) finish();
  }
  void finish() {
    if (count_ == 0) return;
    const PosedShapes all = t_.scene.geometry();
    all.occluded(packet_, LaneSet::first(count_));
    for (int i = 0; i < count_; ++i) {
      const ShadowRay& ray = rays_[i];
      on_end_(ray, packet_.far[i] < 0 ? Rgb{} : straight_.along({ray.origin, ray.segment, ray.reach}));
    }
    count_ = 0;
  }

 private:
  static constexpr int kRays = 8;

  const Tracing& t_;
  const OnEnd& on_end_;
  const StraightLight<S> straight_;
  RayPacket<kRays> packet_{straight_.stops()};
  std::array<ShadowRay, kRays> rays_;
  int count_ = 0;
};

}  // namespace saccade
