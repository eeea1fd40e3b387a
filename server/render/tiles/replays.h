// Replays the paths of a frame at the same points of surfaces in the world of the frame before, see
// SurfaceSamples::replays().
#pragma once

#include "render/camera/pixel_context.h"
#include "render/tiles/surface_pixel.h"

namespace saccade {

// The starts of a frame. Those that bodies carry are put where they were in the frame before.
class CarriedStarts {
 public:
  CarriedStarts(const PixelContext& view, const MovedBodies& moved) : view_(view), moved_(moved) {}

  PlainStart operator()(std::uint32_t, PlainStart start) const {
    if (!moved_.includes(start.carrier)) return start;
    start.point = view_.pointBefore(start.carrier, start.point);
    for (Vec3* normal : {&start.geometric_normal, &start.shading_normal})
      *normal = turned(start.carrier, *normal);
    return start;
  }
  PathStart operator()(std::uint32_t, const SurfaceStart& start) const {
    PathStart path = start.path;
    if (!moved_.includes(start.carrier)) return path;
    Surface& s = path.surface;
    s.point = view_.pointBefore(start.carrier, s.point);
    for (Vec3* v : {&s.geometric_normal, &s.shading_normal, &path.direction}) *v = turned(start.carrier, *v);
    return path;
  }

 private:
  Vec3 turned(std::uint32_t body, Vec3 v) const {
    return motions(view_.before)[body].direction(motions(view_.now)[body].restDirection(v));
  }
  static std::span<const RigidMotion> motions(const PosedView& view) {
    return view.scene.bodies()->motions();
  }

  const PixelContext& view_;
  const MovedBodies& moved_;
};

// Points whose light is not shared have pairs of paths instead, see pairs.h.
template <Shading S, int C>
void renderReplayTile(const PixelContext& view, const MovedBodies& moved, const SeedPlan& seeds,
                      const Tracing& before, Tile tile, const SurfaceStarts& starts, Frame& out) {
  SurfaceSamples& on = *out.surfaces;
  if (!hasPaths(on, tile)) return;
  const auto differs = [&](std::uint32_t i) { return on[i].touched && on[i].kind != SurfaceKind::kNone; };
  forEachPixel(tile, [&](int x, int y) {
    for (int column = x * on.perPixel(); column < (x + 1) * on.perPixel(); ++column) {
      const std::size_t i = on.indexOf(column, y);
      on.replays()[i] = on.light(i);
    }
  });
  tracePoints<S, C>(seeds, before, tile, starts, on, differs, CarriedStarts(view, moved),
                    [&](std::uint32_t i, const ReflectedLight& sum) {
                      on.replays()[i] = lightOf(sum, on[i].paths, starts.base(i), starts.albedo(i));
                    });
}

}  // namespace saccade
