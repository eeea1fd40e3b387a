// The direct light of few lamps without extent at plain surfaces that lie close together, in lanes. Each lamp
// gets a packet of shadow rays.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/instruction_set.h"
#include "render/lights/delta_lamps.h"
#include "render/primary/primary_block.h"
#include "render/tiles/tile_shadow_rays.h"

namespace saccade {

template <Shading S>
class PlainDeltaLight {
 public:
  explicit PlainDeltaLight(const PosedScene& scene) : tracing_{scene, 0, {}} {}

  // Whether all lamps get rays from each surface.
  bool isOfAll() const { return lamps_.getRays() && lamps_.areFew(); }
  // Calls on_light(lane, luminance) for the light of each lamp that reaches a surface.
  void add(const PlainSurfaces& s, LaneSet lanes, const auto& on_light) const {
    Rays rays;
    forEachPart([&](int first) {
      const auto point = s.point.lanes<kWidth>(first), normal = s.geometric_normal.lanes<kWidth>(first);
      rays.origin.store(point + normal * load<kWidth>(&s.offset[first]), first);
    });
    for (std::size_t lamp = 0; lamp < lamps_.size(); ++lamp) {
      aim(lamp, s, lanes, rays);
      if (!rays.lanes.any()) continue;
      const LaneSet open = rays.lanes - blocked(rays);
      if (!straight_.has()) {
        forEachLane(open, [&](int i) { on_light(i, rays.luminance[i]); });
        continue;
      }
      forEachLane(open, [&](int i) {
        const Rgb fraction = straight_.along({rays.origin.at(i), rays.segment.at(i), rays.reach});
        on_light(i, luminance(rays.light.at(i) * fraction));
      });
    }
  }

 private:
  static constexpr int kWidth = 8;
  using F = Floats<kWidth>;

  // To one lamp, and the light that each brings where nothing is in its way.
  struct Rays {
    LaneVectors origin, segment, light;
    alignas(64) float luminance[kLaneVectors];
    float reach;
    LaneSet lanes;  // those that bring any
  };
  static void forEachPart(const auto& f) {
    for (int first = 0; first < kLaneVectors; first += kWidth) f(first);
  }
  void aim(std::size_t lamp, const PlainSurfaces& s, LaneSet lanes, Rays& rays) const {
    const IncidentLight one = lamps_.at(lamp, rays.origin.at(0));
    rays.reach = one.reach, rays.lanes = {};
    if (std::isinf(one.reach))  // a sun shines alike everywhere
      return forEachPart([&](int first) {
        reflect(s, first, lanes, splat<F>(one.direction), splat<F>(one.radiance), rays);
        rays.segment.store(splat<F>(one.segment), first);
      });
    LaneVectors direction{}, radiance{};
    forEachLane(lanes, [&](int i) {
      const IncidentLight light = lamps_.at(lamp, rays.origin.at(i));
      direction.set(i, light.direction), radiance.set(i, light.radiance);
      rays.segment.set(i, light.segment);
    });
    forEachPart([&](int first) {
      reflect(s, first, lanes, direction.lanes<kWidth>(first), radiance.lanes<kWidth>(first), rays);
    });
  }
  // Sets the light that the lanes of a part reflect from `direction`.
  [[gnu::always_inline]] void reflect(const PlainSurfaces& s, int first, LaneSet lanes,
                                      const Vec3T<F>& direction, const Vec3T<F>& radiance, Rays& rays) const {
    const F facing = dot(direction, s.geometric_normal.lanes<kWidth>(first));
    const F along = dot(direction, s.shading_normal.lanes<kWidth>(first));
    const F cosine = select(facing > 0.f, max(F(0.f), along), F(0.f));
    const F scattered = cosine * std::numbers::inv_pi_v<float>;
    const Vec3T<F> light = s.reflectance.lanes<kWidth>(first) * scattered * radiance;
    const F bright = luminance<F>(light);
    rays.light.store(light, first), store(bright, &rays.luminance[first]);
    rays.lanes.bits |= (lanesOf(bright > 0.f) & lanes.from(first)).bits << first;
  }

  LaneSet blocked(const Rays& rays) const {
    return instructionSet() == InstructionSet::kAvx512 ? blocked<16>(rays) : blocked<8>(rays);
  }
  template <int W>
  LaneSet blocked(const Rays& rays) const {
    LaneSet all;
    for (int first = 0; first < kLaneVectors; first += W) {
      const LaneSet lanes = rays.lanes.from(first) & LaneSet::first(W);
      if (!lanes.any()) continue;
      RayPacket<W> packet(straight_.stops());
      const auto copy = [&](const LaneVectors& from, float* x, float* y, float* z) {
        std::copy_n(&from.x[first], W, x), std::copy_n(&from.y[first], W, y),
            std::copy_n(&from.z[first], W, z);
      };
      copy(rays.origin, packet.origin_x, packet.origin_y, packet.origin_z);
      copy(rays.segment, packet.x, packet.y, packet.z);
      std::fill_n(packet.far, W, rays.reach);
      tracing_.scene.geometry().template occluded<W>(packet, lanes);
      forEachLane(lanes, [&](int i) { all.add(first + i, packet.far[i] < 0); });
    }
    return all;
  }

  const Tracing tracing_;
  const DeltaLamps& lamps_ = tracing_.scene.deltaLamps();
  const StraightLight<S> straight_{tracing_};
};

}  // namespace saccade
