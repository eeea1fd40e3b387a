// Replays the paths of a frame at the same points of surfaces in the world of the frame before, see
// SurfaceSamples::replays().
#pragma once

#include "render/camera/pixel_context.h"
#include "render/tiles/surface_pixel.h"

namespace saccade {

// The starts of a frame. Those on bodies are carried to where the bodies were in the frame before.
class CarriedStarts {
 public:
  CarriedStarts(const PixelContext& view, const Frame& now) : view_(view), now_(now) {}

  PlainStart operator()(std::uint32_t i, PlainStart start) const {
    const std::uint32_t body = bodyOf(i);
    if (!moved(body)) return start;
    start.point = view_.pointBefore(body, start.point);
    for (Vec3* normal : {&start.geometric_normal, &start.shading_normal}) *normal = turned(body, *normal);
    return start;
  }
  PathStart operator()(std::uint32_t i, PathStart start) const {
    const std::uint32_t body = bodyOf(i);
    if (!moved(body)) return start;
    Surface& s = start.surface;
    s.point = view_.pointBefore(body, s.point);
    for (Vec3* v : {&s.geometric_normal, &s.shading_normal, &start.direction}) *v = turned(body, *v);
    return start;
  }

 private:
  std::uint32_t bodyOf(std::uint32_t i) const {
    const SurfaceSamples& on = *now_.surfaces;
    return now_.g.body.at(on.columnOf(i) / on.perPixel(), on.rowOf(i)) - 1;
  }
  bool moved(std::uint32_t body) const {
    return body != kNoBody && motions(view_.now)[body] != motions(view_.before)[body];
  }
  Vec3 turned(std::uint32_t body, Vec3 v) const {
    return motions(view_.before)[body].direction(motions(view_.now)[body].restDirection(v));
  }
  static std::span<const RigidMotion> motions(const PosedView& view) {
    return view.scene.bodies()->motions();
  }

  const PixelContext& view_;
  const Frame& now_;
};

template <Shading S, int C>
void renderReplayTile(const PixelContext& view, const SeedPlan& seeds, const Tracing& before, Tile tile,
                      const SurfaceStarts& starts, Frame& out) {
  SurfaceSamples& on = *out.surfaces;
  if (!hasPaths(on, tile)) return;
  tracePoints<S, C>(seeds, before, tile, starts, on, CarriedStarts(view, out),
                    [&](std::uint32_t i, const ReflectedLight& sum) {
                      on.replays()[i] = lightOf(sum, on[i].paths, starts.base(i), starts.albedo(i));
                    });
}

}  // namespace saccade
