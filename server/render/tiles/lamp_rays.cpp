#include "render/tiles/lamp_rays.h"

#include <algorithm>
#include <cmath>

#include "render/lights/lamp_points.h"
#include "render/tiles/delta_light.h"
#include "render/tiles/ray_numbers.h"

namespace saccade {
namespace {

bool isLit(const SurfaceSamples& on, std::size_t point) {
  return on[point].canAskRays() && on.place(point).unoccluded > 0;
}

LitPoint litPointOf(const PlainStart& start) {
  return {start.point, start.shading_normal, start.geometric_normal};
}
LitPoint litPointOf(const SurfaceStart& start) {
  const Surface& s = start.path.surface;
  return {s.point, s.shading_normal, s.geometric_normal};
}

Rgb baseOf(const PlainStart& start) {
  return start.reflectance;
}
Rgb baseOf(const SurfaceStart& start) {
  return start.base.albedo;
}

// Whether a neighbour lies in the plane of a point.
bool isOneSurface(const SurfacePlace& a, const SurfacePlace& b) {
  constexpr float kLeastCosine = 0.8f;
  return dot(a.normal, b.normal) > kLeastCosine &&
         std::abs(dot(b.position - a.position, a.normal)) < a.footprint;
}

}  // namespace

void FrameRays::reset(std::size_t points, int groups) {
  if (areOf(points, groups) && !used_) return;
  groups_ = groups, used_ = false;
  rays_.assign(points * static_cast<std::size_t>(groups), {});
}

void FrameRays::trace(const FrameStarts& frame, std::span<const RayRequest> requests, int count) {
  withKernel(frame.scene.still().shading(), [&]<Shading S>() { traceWith<S>(frame, requests, count); });
}

template <Shading S>
void FrameRays::traceWith(const FrameStarts& frame, std::span<const RayRequest> requests, int count) {
  const Tracing tracing{frame.scene, 0, {}};
  const auto onEnd = [&](const ShadowRay& ray, Rgb fraction) {
    LampRays& rays = rays_[ray.owner];
    rays.visible += ray.weight * luminance(fraction), rays.all += ray.weight;
  };
  TileShadowRays<S, decltype(onEnd)> shadow_rays(tracing, onEnd);
  LampPoints lamps(frame.scene.analyticLight(), frame.scene.strengths());
  const auto add = [&](std::size_t i, int group, const RayNumbers& numbers, Vec3 origin) {
    LampRays& rays = rays_[i];
    rays.unoccluded = lamps.unoccluded(group);
    for (; rays.count < count && rays.unoccluded > 0; ++rays.count) {
      const auto u = [&](int dimension) { return numbers.u(rays.count, dimension); };
      const LampPoints::Point to = lamps.at(group, u(0), u(1), u(2));
      if (to.weight > 0)
        shadow_rays.add({origin, to.position - origin, kShadowEnd, static_cast<std::uint32_t>(i), to.weight});
    }
    rays.count = count;
  };
  for (const RayRequest& request : requests) {
    const auto wants = [&](int group) {
      return (request.groups >> group & 1) && at(request.point, group).count < count;
    };
    bool any = false;
    for (int g = 0; g < groups_; ++g) any = any || wants(g);
    if (!any || !isLit(frame.on, request.point)) continue;
    const RayNumbers numbers(frame.on.columnOf(request.point), frame.on.rowOf(request.point));
    const auto from = [&](const auto& start) {
      lamps.lookFrom(litPointOf(start), baseOf(start));
      for (int g = 0; g < groups_; ++g)
        if (wants(g)) add(indexOf(request.point, g), g, numbers, leave(start));
    };
    if (frame.starts.isPlain(request.point))
      from(frame.starts.plain(request.point));
    else
      from(frame.starts.other(request.point));
  }
  shadow_rays.finish();
}

bool FrameRays::areMixedAround(const SurfaceSamples& on, std::uint32_t point, int group) const {
  bool lit = at(point, group).anyLit(), dark = at(point, group).anyDark();
  const int step = on.perPixel(), column = on.columnOf(point), y = on.rowOf(point);
  for (int ny = std::max(0, y - 1); ny <= std::min(on.height() - 1, y + 1); ++ny)
    for (int nx = column - step; nx <= column + step && !(lit && dark); nx += step) {
      if (nx < 0 || nx >= on.columns()) continue;
      const std::size_t neighbour = on.indexOf(nx, ny);
      const LampRays& rays = at(neighbour, group);
      const bool differs = (rays.anyLit() && !lit) || (rays.anyDark() && !dark);
      if (!differs || !isOneSurface(on.place(point), on.place(neighbour))) continue;
      lit = lit || rays.anyLit(), dark = dark || rays.anyDark();
    }
  return lit && dark;
}

}  // namespace saccade
