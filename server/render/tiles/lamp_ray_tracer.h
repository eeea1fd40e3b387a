// Shadow rays from starts to groups of lamps, traced in packets.
#pragma once

#include <span>

#include "render/lights/lamp_points.h"
#include "render/tiles/delta_light.h"
#include "render/tiles/lamp_rays.h"
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
  // `rays`: of points, and of each point by group.
  LampRayTracer(const PosedScene& scene, std::span<LampRays> rays)
      : tracing_{scene, 0, {}},
        rays_(rays),
        lamps_(scene.analyticLight(), scene.strengths()),
        shadow_rays_(tracing_, on_end_) {}

  // Goes on until a start has `count` rays to each group g with bit g in `groups`. Those to group 0 are
  // rays[first].
  void add(const auto& start, std::size_t first, std::uint32_t groups, int count, const RayNumbers& numbers) {
    lamps_.lookFrom(litPoint(start), baseOf(start));
    forEachLane(LaneSet{groups}, [&](int group) {
      addGroup(leave(start), group, first + static_cast<std::size_t>(group), count, numbers);
    });
  }
  void finish() { shadow_rays_.finish(); }

 private:
  void addGroup(Vec3 origin, int group, std::size_t i, int count, const RayNumbers& numbers) {
    LampRays& rays = rays_[i];
    rays.unoccluded = lamps_.unoccluded(group);
    for (; rays.count < count && rays.unoccluded > 0; ++rays.count) {
      const auto u = [&](int dimension) { return numbers.u(rays.count, dimension); };
      const LampPoints::Point to = lamps_.at(group, u(0), u(1), u(2));
      if (to.weight > 0)
        shadow_rays_.add(
            {origin, to.position - origin, kShadowEnd, static_cast<std::uint32_t>(i), to.weight});
    }
    rays.count = count;
  }

  struct OnEnd {
    std::span<LampRays> to;
    void operator()(const ShadowRay& ray, Rgb fraction) const {
      LampRays& rays = to[ray.owner];
      rays.visible += ray.weight * luminance(fraction), rays.all += ray.weight;
    }
  };

  const Tracing tracing_;
  const std::span<LampRays> rays_;
  const OnEnd on_end_{rays_};
  LampPoints lamps_;
  TileShadowRays<S, OnEnd> shadow_rays_;
};

}  // namespace saccade
