// The points that a pixel shows, as SurfaceSamples has them.
#pragma once

#include <functional>

#include "base/scratch.h"
#include "render/primary/sub_pixels_shown.h"
#include "render/tiles/delta_light.h"
#include "render/tiles/plain_delta_light.h"
#include "render/tiles/surface_place.h"
#include "render/tiles/tile_samples.h"

namespace saccade {

inline constexpr int kMaxTilePoints = kMaxTileEdge * kMaxTileEdge * static_cast<int>(kSubPixels);

// The points of a tile, as they are found.
template <Shading S>
class TilePoints {
 public:
  TilePoints(const PixelContext& view, const FrameMotion& motion, Tile tile, Frame& out)
      : view_(view), motion_(motion), tile_(tile), out_(out) {}

  // Where the block of a pixel is made, to be set().
  PrimaryBlock& block(int x, int y) { return memory_->blocks[blockOf(x, y)]; }
  // The one point of each pixel that shows a plain surface.
  void set(const PrimaryBlock& block) {
    const PlainSurfaces& s = block.surfaces;
    LaneVectors white;
    view_.now.scene.analyticLight().at({s.point, s.shading_normal, s.geometric_normal}, block.plain,
                                       view_.now.scene.strengths(), white);
    const PlainPlaces places(s, white);
    forEachLane(block.plain, [&](int lane) {
      const std::size_t i = out_.surfaces->indexOf(block.x(lane), block.y(lane));
      SurfacePoint& point = (*out_.surfaces)[i] = {};
      if (has_bodies_) carried(block.x(lane), block.y(lane)).body = kNoBody;
      if (s.albedo[lane] <= 0) return;
      point.share = 1;
      SurfacePlace& place = out_.surfaces->place(i);
      point.kind = places.set(s, lane, place);
      if (point.kind != SurfaceKind::kNone && has_bodies_)
        carried(block.x(lane), block.y(lane)) = setMotion(view_.now.scene, motion_, placeOf(block, lane),
                                                          seenPoint(s, lane), point.light_moves, place);
    });
    if (plain_deltas_.isOfAll())
      plain_deltas_.add(s, block.plain, [&](int lane, float light) {
        out_.g.emission.at(block.x(lane), block.y(lane)) += light;
      });
  }
  // The one point of another pixel.
  void set(int x, int y, const PrimaryHit& centre) {
    setPoint(x, y, centre, 1);
    if (centre.valid) out_.g.emission.at(x, y) += luminance(mirrorImage<S>(view_.now.scene, centre.start));
  }

  // The features of a pixel, with a point for each surface that it shows, at the centre of the pixel where
  // that shows it, too. Albedo and emission are means over the pixel. Guides are of the centre.
  void setJittered(int x, int y) {
    SubPixels<S> shown(view_, x, y);
    shown.lookAtEdges();
    const PrimaryHit& centre = shown.centre();
    writeFeatures(centre, view_.now.camera, view_.before.camera, x, y, out_.g);
    const float A = out_.g.albedo.at(x, y) = shown.albedo();
    out_.g.emission.at(x, y) = shown.emission() + shown.image();
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

  // Adds the light of lamps without extent to what pixels emit, where it is not known yet.
  void addDeltaLight() {
    if (!any_other_ && plain_deltas_.isOfAll()) return;
    const SurfaceSamples& on = *out_.surfaces;
    const int width = out_.width();
    const auto onLight = [&](std::uint32_t pixel, float light) {
      const int i = static_cast<int>(pixel);
      out_.g.emission.at(i % width, i / width) += light;
    };
    DeltaLight<S, decltype(onLight)> light(view_.now.scene, onLight);
    forEachPixel(tile_, [&](int x, int y) {
      const auto pixel = static_cast<std::uint32_t>(y * width + x);
      for (int column = x * on.perPixel(); column < (x + 1) * on.perPixel(); ++column) {
        const float share = on.at(column, y).share;
        if (share <= 0 || (isPlain(column, y) && plain_deltas_.isOfAll())) continue;
        const float scale = share * out_.g.albedo.at(x, y);
        const RayNumbers numbers(column, y);
        if (isPlain(column, y)) {
          const PlainStart start = plainStart(column, y);
          light.add(pixel, start, scale / start.albedo, numbers);
        } else {
          const SurfaceStart& start = memory_->others[indexOf(column, y)];
          light.add(pixel, start, scale / start.albedo, numbers);
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
    std::array<PrimaryBlock, kTileBlocks * kTileBlocks> blocks;  // unless there is jitter
    // On the bodies that carry them; of kNoBody: on none. Of a scene without bodies it is not set.
    std::array<ShapePoint, kMaxTilePoints> carried;
  };

  // The point that a ray has found. `share`: of the pixel's albedo.
  void setPoint(int column, int y, const PrimaryHit& hit, float share) {
    SurfacePoint& point = out_.surfaces->at(column, y) = {};
    any_other_ = true;
    carried(column, y).body = kNoBody;
    const Guide& guide = hit.guide;
    const float albedo = luminance(guide.albedo);
    if (!hit.valid || albedo <= 0) return;
    SurfaceStart& start = memory_->others[indexOf(column, y)];
    setStart<S>(hit.start, albedo, start);
    point.share = share;
    SurfacePlace& place = out_.surfaces->place(out_.surfaces->indexOf(column, y));
    point.kind = setPlace(view_.now, hit, start, place);
    if (point.kind != SurfaceKind::kNone && view_.now.scene.bodies())
      carried(column, y) =
          setMotion(view_.now.scene, motion_, guide.on, seenPoint(hit.start), point.light_moves, place);
  }

  // Where on its shape a plain lane is; only the body is known where none deforms.
  ShapePoint placeOf(const PrimaryBlock& block, int lane) const {
    if (view_.now.scene.deformed()) return block.on[static_cast<std::size_t>(lane)];
    return ShapePoint::ofBody(out_.g.body.at(block.x(lane), block.y(lane)) - 1);
  }

  void keepStart(int column, int y, SurfaceStarts& starts) const {
    const std::size_t i = out_.surfaces->indexOf(column, y);
    if (view_.now.scene.deformed()) starts.setCarried(i, carried(column, y));
    if (isPlain(column, y)) return starts.set(i, plainStart(column, y));
    SurfaceStart& start = memory_->others[indexOf(column, y)];
    start.carrier = carrierOf(column, y);
    starts.set(i, start);
  }
  PlainStart plainStart(int x, int y) const {
    return {memory_->blocks[blockOf(x, y)].surfaces, laneOf(x, y), carrierOf(x, y)};
  }

  int laneOf(int x, int y) const {
    return (y - tile_.y0) % kBlockEdge * kBlockEdge + (x - tile_.x0) % kBlockEdge;
  }

  std::size_t blockOf(int x, int y) const {
    return static_cast<std::size_t>((y - tile_.y0) / kBlockEdge * kTileBlocks + (x - tile_.x0) / kBlockEdge);
  }
  std::size_t indexOf(int column, int y) const {
    const int per_pixel = out_.surfaces->perPixel();
    return static_cast<std::size_t>(((y - tile_.y0) * (tile_.x1 - tile_.x0) - tile_.x0) * per_pixel + column);
  }
  bool isPlain(int x, int y) const {
    return !is_jittered_ && memory_->blocks[blockOf(x, y)].plain.has(laneOf(x, y));
  }
  std::uint32_t carrierOf(int column, int y) const { return has_bodies_ ? carried(column, y).body : kNoBody; }
  ShapePoint& carried(int column, int y) const { return memory_->carried[indexOf(column, y)]; }

  const PixelContext& view_;
  const FrameMotion& motion_;
  Tile tile_;
  Frame& out_;
  const bool has_bodies_ = view_.now.scene.bodies() != nullptr;
  const bool is_jittered_ = out_.surfaces->perPixel() > 1;  // then there are no blocks
  bool any_other_ = false;                                  // whether any point is not plain
  const PlainDeltaLight<S> plain_deltas_{view_.now.scene};
  const Scratch<Memory> memory_;
};

template <Shading S>
void renderSurfaceTile(const PixelContext& view, const FrameMotion& motion, Tile tile,
                       const std::function<void(Tile)>& on_tile, SurfaceStarts& starts, Frame& out) {
  TilePoints<S> points(view, motion, tile, out);
  if (out.surfaces->perPixel() == 1)
    forEachPrimary<S>(
        view, tile, out.g, [&](int x, int y) -> PrimaryBlock& { return points.block(x, y); },
        [&](const PrimaryBlock& block) { points.set(block); },
        [&](int x, int y, const PrimaryHit& hit) { points.set(x, y, hit); });
  else
    forEachPixel(tile, [&](int x, int y) { points.setJittered(x, y); });
  if (view.now.scene.still().deltaLamps().getRays()) points.addDeltaLight();
  on_tile(tile);
  points.keepStarts(starts);
}

}  // namespace saccade
