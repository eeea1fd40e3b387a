#include "render/tiles/lamp_rays.h"

#include <algorithm>
#include <cmath>

#include "render/tiles/lamp_ray_tracer.h"

namespace saccade {
namespace {

bool isLit(const SurfaceSamples& on, std::size_t point) {
  return on[point].canAskRays() && on.place(point).unoccluded > 0;
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
  LampRayTracer<S> tracer(frame.scene, rays_);
  for (const RayRequest& request : requests) {
    std::uint32_t wanted = 0;
    for (int g = 0; g < groups_; ++g)
      if (at(request.point, g).count < count) wanted |= request.groups & 1u << g;
    if (wanted == 0 || !isLit(frame.on, request.point)) continue;
    const RayNumbers numbers(frame.on.columnOf(request.point), frame.on.rowOf(request.point));
    const std::size_t first = indexOf(request.point, 0);
    if (frame.starts.isPlain(request.point))
      tracer.add(frame.starts.plain(request.point), first, wanted, count, numbers);
    else
      tracer.add(frame.starts.other(request.point), first, wanted, count, numbers);
  }
  tracer.finish();
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
