// The points that a pixel shows, as SurfaceSamples has them.
#pragma once

#include <functional>

#include "base/scratch.h"
#include "render/primary/sub_pixels_shown.h"
#include "render/surface/scatter.h"
#include "render/tiles/delta_light.h"
#include "render/tiles/surface_start.h"
#include "render/tiles/tile_samples.h"
#include "render/world/changing_light.h"
#include "render/world/sliding_surfaces.h"

namespace saccade {

inline constexpr float kLeastSurfaceAlbedo = 1e-4f;  // darker surfaces share no light
inline constexpr int kMaxTilePoints = kMaxTileEdge * kMaxTileEdge * static_cast<int>(kSubPixels);

// The motion from the frame before into a frame.
struct FrameMotion {
  const MovedBodies& moved;
  const ChangingLight& light;
  const SlidingSurfaces& sliding;
};

inline LitPoint litPoint(const PathStart& start) {
  return {start.surface.point, start.surface.shading_normal, start.surface.geometric_normal};
}

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

// The points of a tile, as they are found.
template <Shading S>
class TilePoints {
 public:
  TilePoints(const PixelContext& view, const FrameMotion& motion, Tile tile, Frame& out)
      : view_(view), motion_(motion), tile_(tile), out_(out) {}

  // The one point of each pixel that shows a plain surface.
  void set(const PrimaryBlock& block) {
    const PlainSurfaces& s = memory_->plain[blockOf(block.x0, block.y0)] = block.surfaces;
    LaneVectors white;
    view_.now.scene.analyticLight().at({s.point, s.shading_normal, s.geometric_normal}, block.plain,
                                       view_.now.scene.strengths(), white);
    forEachLane(block.plain, [&](int lane) {
      SurfacePoint& point = out_.surfaces->at(block.x(lane), block.y(lane)) = {};
      isPlain(block.x(lane), block.y(lane)) = true;
      carried(block.x(lane), block.y(lane)).body = kNoBody;
      const float albedo = s.albedo[lane];
      if (albedo <= 0) return;
      point.share = 1;
      if (albedo <= kLeastSurfaceAlbedo) return;
      point.kind = SurfaceKind::kDiffuse;
      const float unoccluded = luminance(s.reflectance.at(lane) * white.at(lane)) / albedo;
      SurfacePlace& place = out_.surfaces->place(out_.surfaces->indexOf(block.x(lane), block.y(lane)));
      place = {s.point.at(lane), s.shading_normal.at(lane), s.width[lane], unoccluded};
      if (!view_.now.scene.bodies()) return;
      ShapePoint& on = carried(block.x(lane), block.y(lane));
      on = view_.now.scene.deformed() ? block.on[static_cast<std::size_t>(lane)]
                                      : ShapePoint::ofBody(out_.g.body.at(block.x(lane), block.y(lane)) - 1);
      setMotion({s.point.at(lane), s.geometric_normal.at(lane), s.offset[lane]}, point, place, on);
    });
  }
  // The one point of another pixel.
  void set(int x, int y, const PrimaryHit& centre) { setPoint(x, y, centre, 1); }

  // The features of a pixel, with a point for each surface that it shows, at the centre of the pixel where
  // that shows it, too. Albedo and emission are means over the pixel. Guides are of the centre.
  void setJittered(int x, int y) {
    SubPixels<S> shown(view_, x, y);
    shown.lookAtEdges();
    const PrimaryHit& centre = shown.centre();
    writeFeatures(centre, view_.now.camera, view_.before.camera, x, y, out_.g);
    const float A = out_.g.albedo.at(x, y) = shown.albedo();
    out_.g.emission.at(x, y) = shown.emission();
    for (SurfacePoint& p : out_.surfaces->of(x, y)) p = {};
    if (A <= 0) return;
    int column = x * out_.surfaces->perPixel();
    const float pixel = view_.now.camera.pixelAt(centre.direction);
    shown.forEachSurface([&](const PrimaryHit& hit, float albedo) {
      const bool central =
          isOneSurface(hit, centre, pixel) && luminance(centre.guide.albedo) >= kLeastAlbedo * A;
      setPoint(column++, y, central ? centre : hit, albedo / A);
    });
  }

  // Adds the light of lamps without extent to what pixels emit.
  void addDeltaLight() {
    const SurfaceSamples& on = *out_.surfaces;
    DeltaLight<S> light(view_.now.scene, out_);
    forEachPixel(tile_, [&](int x, int y) {
      for (int column = x * on.perPixel(); column < (x + 1) * on.perPixel(); ++column) {
        const float share = on.at(column, y).share;
        if (share <= 0) continue;
        const float scale = share * out_.g.albedo.at(x, y);
        if (isPlain(column, y)) {
          const PlainStart start = plainStart(column, y);
          light.add(x, y, start, scale / start.albedo);
        } else {
          const SurfaceStart& start = memory_->others[indexOf(column, y)];
          light.add(x, y, start, scale / start.albedo);
        }
      }
    });
    light.finish();
  }

  // Copies where paths and shadow rays start, of points that may get any.
  void keepStarts(SurfaceStarts& starts) const {
    const SurfaceSamples& on = *out_.surfaces;
    bool any = false, any_of_others = false, any_near_shadow = false;
    forEachPixel(tile_, [&](int x, int y) {
      const bool all = on.hasUncacheable(x, y);
      any_of_others |= all;
      for (int column = x * on.perPixel(); column < (x + 1) * on.perPixel(); ++column) {
        const SurfacePoint& p = on.at(column, y);
        const bool paths = p.share > 0 && (all || !p.baked);
        if (!paths && !p.near_shadow) continue;
        any |= paths, any_near_shadow |= p.near_shadow;
        keepStart(column, y, starts);
      }
    });
    starts.setAny(any, any_of_others, any_near_shadow);
  }

 private:
  static constexpr int kTileBlocks = kMaxTileEdge / kBlockEdge;  // across
  struct Memory {
    std::array<SurfaceStart, kMaxTilePoints> others;
    std::array<PlainSurfaces, kTileBlocks * kTileBlocks> plain;
    std::array<bool, kMaxTilePoints> is_plain;
    std::array<ShapePoint, kMaxTilePoints> carried;  // on the bodies that carry them; of kNoBody: on none
  };

  // The point that a ray has found. `share`: of the pixel's albedo.
  void setPoint(int column, int y, const PrimaryHit& hit, float share) {
    SurfacePoint& point = out_.surfaces->at(column, y) = {};
    isPlain(column, y) = false, carried(column, y).body = kNoBody;
    const Guide& guide = hit.guide;
    const float albedo = luminance(guide.albedo);
    if (!hit.valid || albedo <= 0) return;
    SurfaceStart& start = memory_->others[indexOf(column, y)];
    setStart<S>(hit.start, albedo, start);
    point.share = share;
    if (!guide.hit || !guide.has_base || albedo <= kLeastSurfaceAlbedo) return;
    point.kind = start.base.all ? SurfaceKind::kDiffuse : SurfaceKind::kMixed;
    const Rgb white = view_.now.scene.analyticLight().at(litPoint(hit.start), view_.now.scene.strengths());
    SurfacePlace& place = out_.surfaces->place(out_.surfaces->indexOf(column, y));
    place = {guide.point, guide.normal, view_.now.camera.pixelAt(hit.direction) * guide.t,
             luminance(start.base.albedo * white) / albedo};
    const Surface& surface = hit.start.surface;
    if (!view_.now.scene.bodies()) return;
    carried(column, y) = guide.on;
    setMotion({surface.point, surface.geometric_normal, surface.offset}, point, place, carried(column, y));
  }

  // Sets the place of a point of a body, and whether direct light moves there. Clears on.body where the body
  // does not carry the light of the point along.
  void setMotion(const SeenPoint& seen, SurfacePoint& point, SurfacePlace& place, ShapePoint& on) const {
    point.light_moves = motion_.light.at(seen.position);
    if (on.body == kNoBody) return;
    point.light_moves = point.light_moves || motion_.moved.includes(on.body);
    if (motion_.sliding.at(on.body, seen)) {
      on.body = kNoBody;
      return;
    }
    const PosedBodies& bodies = *view_.now.scene.bodies();
    place.position = bodies.cachePlace(on, place.position);
    place.normal = bodies.cacheNormal(on, place.normal);
  }

  void keepStart(int column, int y, SurfaceStarts& starts) const {
    const std::size_t i = out_.surfaces->indexOf(column, y);
    if (view_.now.scene.deformed()) starts.setCarried(i, carried(column, y));
    if (isPlain(column, y)) return starts.set(i, plainStart(column, y));
    SurfaceStart& start = memory_->others[indexOf(column, y)];
    start.carrier = carried(column, y).body;
    starts.set(i, start);
  }
  PlainStart plainStart(int x, int y) const {
    const int lane = (y - tile_.y0) % kBlockEdge * kBlockEdge + (x - tile_.x0) % kBlockEdge;
    return {memory_->plain[blockOf(x, y)], lane, carried(x, y).body};
  }

  std::size_t blockOf(int x, int y) const {
    return static_cast<std::size_t>((y - tile_.y0) / kBlockEdge * kTileBlocks + (x - tile_.x0) / kBlockEdge);
  }
  std::size_t indexOf(int column, int y) const {
    const int per_pixel = out_.surfaces->perPixel();
    return static_cast<std::size_t>(((y - tile_.y0) * (tile_.x1 - tile_.x0) - tile_.x0) * per_pixel + column);
  }
  bool& isPlain(int column, int y) const { return memory_->is_plain[indexOf(column, y)]; }
  ShapePoint& carried(int column, int y) const { return memory_->carried[indexOf(column, y)]; }

  const PixelContext& view_;
  const FrameMotion& motion_;
  Tile tile_;
  Frame& out_;
  const Scratch<Memory> memory_;
};

template <Shading S>
void renderSurfaceTile(const PixelContext& view, const FrameMotion& motion, Tile tile,
                       const std::function<void(Tile)>& on_tile, SurfaceStarts& starts, Frame& out) {
  TilePoints<S> points(view, motion, tile, out);
  if (out.surfaces->perPixel() == 1)
    forEachPrimary<S>(
        view, tile, out.g, [&](const PrimaryBlock& block) { points.set(block); },
        [&](int x, int y, const PrimaryHit& hit) { points.set(x, y, hit); });
  else
    forEachPixel(tile, [&](int x, int y) { points.setJittered(x, y); });
  if (view.now.scene.still().deltaLamps().areFew()) points.addDeltaLight();
  on_tile(tile);
  points.keepStarts(starts);
}

}  // namespace saccade
