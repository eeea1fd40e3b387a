// Replays the touched paths of a frame at the same points of surfaces in the world of the frame before, for
// SurfaceSamples::changes().
#pragma once

#include "render/camera/pixel_context.h"
#include "render/tiles/surface_pixel.h"

namespace saccade {

// The starts of a frame. Those that bodies carry are put where they were in the frame before.
class CarriedStarts {
 public:
  CarriedStarts(const PixelContext& view, const MovedBodies& moved, const SurfaceStarts& starts)
      : view_(view), moved_(moved), starts_(starts) {}

  PlainStart operator()(std::uint32_t i, PlainStart start) const {
    if (!moved_.includes(start.carrier)) return start;
    const ShapePoint on = starts_.carried(i);
    start.point = view_.pointBefore(on, start.point);
    for (Vec3* normal : {&start.geometric_normal, &start.shading_normal}) *normal = turned(on, *normal);
    return start;
  }
  PathStart operator()(std::uint32_t i, const SurfaceStart& start) const {
    PathStart path = start.path;
    if (!moved_.includes(start.carrier)) return path;
    const ShapePoint on = starts_.carried(i);
    Surface& s = path.surface;
    s.point = view_.pointBefore(on, s.point);
    for (Vec3* v : {&s.geometric_normal, &s.shading_normal, &path.direction}) *v = turned(on, *v);
    return path;
  }

 private:
  Vec3 turned(const ShapePoint& on, Vec3 v) const {
    return view_.now.scene.turned(on, v, view_.before.scene);
  }

  const PixelContext& view_;
  const MovedBodies& moved_;
  const SurfaceStarts& starts_;
};

// Points whose light is not shared have pairs of paths instead, see pairs.h.
template <Shading S, int C>
void renderReplayTile(const PixelContext& view, const MovedBodies& moved, const TouchedPaths& touched,
                      const SeedPlan& seeds, const Tracing& before, Tile tile, const SurfaceStarts& starts,
                      Frame& out) {
  SurfaceSamples& on = *out.surfaces;
  const auto differs = [&](std::uint32_t i, std::uint32_t path) {
    return on[i].kind != SurfaceKind::kNone && touched.has(i, path);
  };
  const auto add = [&](std::uint32_t i, const PathResults<C>& found, std::uint32_t slot, double& sum) {
    sum += residualOf(found, slot, starts.base(i));
  };
  tracePoints<S, C, double>(seeds, before, tile, starts, on, differs, CarriedStarts(view, moved, starts), add,
                            [&](std::uint32_t i, double light) {
                              const double change = (touched.light(i) - light) / on[i].paths;
                              on.changes()[i] = static_cast<float>(change) / starts.albedo(i);
                            });
}

}  // namespace saccade
