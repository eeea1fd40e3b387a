// Where the light of a point that a pixel shows is kept, see SurfacePlace.
#pragma once

#include <array>
#include <bit>
#include <cstddef>

#include "cache/lattice/lanes.h"
#include "frame/surface_samples.h"
#include "render/primary/gbuffer_pass.h"
#include "render/surface/scatter.h"
#include "render/tiles/surface_start.h"
#include "render/world/changing_light.h"
#include "render/world/sliding_surfaces.h"

namespace saccade {

inline constexpr float kLeastSurfaceAlbedo = 1e-4f;  // darker surfaces share no light

// The motion from the frame before into a frame.
struct FrameMotion {
  const MovedBodies& moved;
  const ChangingLight& light;
  const SlidingSurfaces& sliding;
};

// Sets its parts one by one: a copy of them all would wait for each of them to reach the cache.
template <Shading S>
void setStart(const PathStart& path, float albedo, SurfaceStart& out) {
  const Scatter<S> scatter(path.surface, path.direction);
  const bool has_base = scatter.hasBase() && path.surface.opacity >= 1;
  out.path = path;
  out.base.albedo = has_base ? scatter.diffuseAlbedo() : Rgb{};
  out.base.all = has_base && scatter.isDiffuse();
  out.albedo = albedo;
}

// The places of plain surfaces, by lane. `white`: AnalyticLight::at() of them.
class PlainPlaces {
 public:
  PlainPlaces(const PlainSurfaces& s, const LaneVectors& white) {
    for (int first = 0; first < kLaneVectors; first += kWidth) {
      const auto point = s.point.lanes<kWidth>(first), normal = s.shading_normal.lanes<kWidth>(first);
      const F unoccluded = luminance<F>(s.reflectance.lanes<kWidth>(first) * white.lanes<kWidth>(first)) /
                           load<kWidth>(&s.albedo[first]);
      const auto column = [](const F& f) { return Octet(static_cast<__m256>(f)); };
      const auto rows =
          transposed({column(point.x), column(point.y), column(point.z), column(normal.x), column(normal.y),
                      column(normal.z), column(load<kWidth>(&s.width[first])), column(unoccluded)});
      for (int i = 0; i < kWidth; ++i) places_[first + i] = std::bit_cast<SurfacePlace>(rows[i]);
    }
  }
  // Sets the place of a lane that is not black. Returns its kind; with kNone there is no place.
  SurfaceKind set(const PlainSurfaces& s, int lane, SurfacePlace& place) const {
    if (s.albedo[lane] <= kLeastSurfaceAlbedo) return SurfaceKind::kNone;
    place = places_[lane];
    return SurfaceKind::kDiffuse;
  }

 private:
  static constexpr int kWidth = 8;
  using F = Floats<kWidth>;
  static_assert(sizeof(SurfacePlace) == sizeof(Octet) && offsetof(SurfacePlace, normal) == 12 &&
                offsetof(SurfacePlace, footprint) == 24 && offsetof(SurfacePlace, unoccluded) == 28);

  std::array<SurfacePlace, kLaneVectors> places_;
};

// Sets the place of another surface that reflects light, where paths start at `start`.
inline SurfaceKind setPlace(const PosedView& view, const PrimaryHit& hit, const SurfaceStart& start,
                            SurfacePlace& place) {
  const Guide& guide = hit.guide;
  if (!guide.hit || !guide.has_base || start.albedo <= kLeastSurfaceAlbedo) return SurfaceKind::kNone;
  const Surface& s = hit.start.surface;
  const Rgb white =
      view.scene.analyticLight().at({s.point, s.shading_normal, s.geometric_normal}, view.scene.strengths());
  place = {guide.point, guide.normal, view.camera.pixelAt(hit.direction) * guide.t,
           luminance(start.base.albedo * white) / start.albedo};
  return start.base.all ? SurfaceKind::kDiffuse : SurfaceKind::kMixed;
}

inline SeenPoint seenPoint(const PlainSurfaces& s, int lane) {
  return {s.point.at(lane), s.geometric_normal.at(lane), s.offset[lane]};
}
inline SeenPoint seenPoint(const PathStart& start) {
  return {start.surface.point, start.surface.geometric_normal, start.surface.offset};
}

// Sets the place of a point in a scene with bodies, and whether direct light moves there. `on`: where on its
// shape the point is. Returns the same, without a body where none carries the light of the point along.
inline ShapePoint setMotion(const PosedScene& scene, const FrameMotion& motion, ShapePoint on,
                            const SeenPoint& seen, bool& light_moves, SurfacePlace& place) {
  light_moves = motion.light.at(seen.position);
  if (on.body == kNoBody) return on;
  light_moves = light_moves || motion.moved.includes(on.body);
  if (motion.sliding.at(on.body, seen)) return {};
  const PosedBodies& bodies = *scene.bodies();
  place.position = bodies.cachePlace(on, place.position);
  place.normal = bodies.cacheNormal(on, place.normal);
  return on;
}

}  // namespace saccade
