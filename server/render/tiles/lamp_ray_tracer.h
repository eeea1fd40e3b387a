// Shadow rays from starts to groups of lamps, traced in packets.
#pragma once

#include <span>

#include "render/lights/lamp_points.h"
#include "render/tiles/delta_light.h"
#include "render/tiles/lamp_rays.h"
#include "render/tiles/ray_bits.h"
#include "render/tiles/ray_numbers.h"

namespace saccade {

inline LitPoint litPoint(const PlainStart& start) {
  return {start.point, start.shading_normal, start.geometric_normal};
}
inline LitPoint litPoint(const SurfaceStart& start) {
  const Surface& s = start.path.surface;
  return {s.point, s.shading_normal, s.geometric_normal};
}

inline Rgb baseOf(const PlainStart& start) {
  return start.reflectance;
}
inline Rgb baseOf(const SurfaceStart& start) {
  return start.base.albedo;
}

template <Shading S>
class LampRayTracer {
 public:
  // `rays`: of points, and of each point by group. `bits`: likewise, or none.
  LampRayTracer(const PosedScene& scene, std::span<LampRays> rays, std::span<RayBits> bits = {})
      : tracing_{scene, 0, {}},
        rays_(rays),
        on_end_{rays, bits},
        lamps_(scene.analyticLight(), scene.strengths()),
        shadow_rays_(tracing_, on_end_) {}

  // Goes on until a start has `count` rays to each group g with bit g in `groups`. Those to group 0 are
  // rays[first]. `known`: rays by group that need not be traced; nullptr: none.
  void add(const auto& start, std::size_t first, std::uint32_t groups, int count, const RayNumbers& numbers,
           const RayBits* known = nullptr) {
    lamps_.lookFrom(litPoint(start), baseOf(start));
    forEachLane(LaneSet{groups}, [&](int group) {
      addGroup(leave(start), group, first + static_cast<std::size_t>(group), count, numbers,
               known ? known[group] : RayBits{});
    });
  }
  void finish() { shadow_rays_.finish(); }

  std::size_t traced() const { return traced_; }  // rays so far

 private:
  void addGroup(Vec3 origin, int group, std::size_t i, int count, const RayNumbers& numbers, RayBits known) {
    LampRays& rays = rays_[i];
    rays.unoccluded = lamps_.unoccluded(group);
    for (; rays.count < count && rays.unoccluded > 0; ++rays.count) {
      const auto u = [&](int dimension) { return numbers.u(rays.count, dimension); };
      const LampPoints::Point to = lamps_.at(group, u(0), u(1), u(2));
      if (!(to.weight > 0)) continue;
      const ShadowRay ray{.origin = origin,
                          .segment = to.position - origin,
                          .reach = kShadowEnd,
                          .owner = static_cast<std::uint32_t>(i),
                          .weight = to.weight,
                          .bit = RayBits::of(rays.count)};
      if (ray.bit & (known.lit | known.dark))
        on_end_(ray, ray.bit & known.lit ? Rgb{1, 1, 1} : Rgb{});
      else
        shadow_rays_.add(ray), ++traced_;
    }
    rays.count = count;
  }

  struct OnEnd {
    std::span<LampRays> to;
    std::span<RayBits> bits;
    void operator()(const ShadowRay& ray, Rgb fraction) const {
      LampRays& rays = to[ray.owner];
      rays.visible += ray.weight * luminance(fraction), rays.all += ray.weight;
      if (bits.empty()) return;
      if (fraction == Rgb{1, 1, 1}) bits[ray.owner].lit |= ray.bit;
      if (fraction == Rgb{}) bits[ray.owner].dark |= ray.bit;
    }
  };

  const Tracing tracing_;
  const std::span<LampRays> rays_;
  const OnEnd on_end_;
  LampPoints lamps_;
  TileShadowRays<S, OnEnd> shadow_rays_;
  std::size_t traced_ = 0;
};

}  // namespace saccade
