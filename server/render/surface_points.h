// The points that a pixel shows, as SurfaceSamples has them.
#pragma once

#include <functional>

#include "base/scratch.h"
#include "render/scatter.h"
#include "render/sub_pixels_shown.h"
#include "render/surface_start.h"
#include "render/tile_samples.h"

namespace saccade {

inline constexpr float kLeastSurfaceAlbedo = 1e-4f;  // darker surfaces share no light
inline constexpr int kMaxTilePoints = kMaxTileEdge * kMaxTileEdge * static_cast<int>(kSubPixels);

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
  TilePoints(const PixelContext& view, Tile tile, Frame& out) : view_(view), tile_(tile), out_(out) {}

  // The features of a block's pixels, from their centres, and their one point each.
  void set(Tile block, std::span<const PrimaryHit> centres) {
    std::array<LitPoint, kMostPoints> points;
    std::array<Rgb, kMostPoints> white;
    for (std::size_t i = 0; i < centres.size(); ++i) points[i] = litPoint(centres[i].start);
    view_.scene.analyticLight().at(points, view_.strengths, std::span(white).first(centres.size()));
    std::size_t i = 0;
    forEachPixel(block, [&](int x, int y) {
      writeFeatures(centres[i], view_.camera, view_.prev, x, y, out_.g);
      setPoint(x, y, centres[i], white[i], 1);
      ++i;
    });
  }

  // The same for one pixel, with a point for each surface that the pixel shows, at the centre of the pixel
  // where that shows it, too. Albedo and emission are means over the pixel. Guides are of the centre.
  void setJittered(const PrimaryHit& centre, int x, int y) {
    writeFeatures(centre, view_.camera, view_.prev, x, y, out_.g);
    const SubPixels<S> shown(view_, x, y);
    const float A = out_.g.albedo.at(x, y) = shown.albedo();
    out_.g.emission.at(x, y) = shown.emission();
    for (SurfacePoint& p : out_.surfaces->of(x, y)) p = {};
    if (A <= 0) return;
    int column = x * out_.surfaces->perPixel();
    const float pixel = view_.camera.pixelAt(centre.direction);
    shown.forEachSurface([&](const PrimaryHit& hit, float albedo) {
      const bool central =
          isOneSurface(hit, centre, pixel) && luminance(centre.guide.albedo) >= kLeastAlbedo * A;
      const PrimaryHit& shows = central ? centre : hit;
      const Rgb white = view_.scene.analyticLight().at(litPoint(shows.start), view_.strengths);
      setPoint(column++, y, shows, white, albedo / A);
    });
  }

  // Copies where paths start, of points that may get any.
  void keepStarts(std::vector<SurfaceStart>& starts) const {
    const SurfaceSamples& on = *out_.surfaces;
    forEachPixel(tile_, [&](int x, int y) {
      const bool all = on.showsOthers(x, y);
      for (int column = x * on.perPixel(); column < (x + 1) * on.perPixel(); ++column)
        if (const SurfacePoint& p = on.at(column, y); p.share > 0 && (all || !p.baked))
          starts[on.indexOf(column, y)] = startAt(column, y);
    });
  }

 private:
  // The point that a ray has found. `share`: of the pixel's albedo; `white`: what a white surface would
  // reflect of the light in closed form.
  void setPoint(int column, int y, const PrimaryHit& hit, Rgb white, float share) {
    SurfacePoint& point = out_.surfaces->at(column, y) = {};
    const Guide& guide = hit.guide;
    const float albedo = luminance(guide.albedo);
    if (!hit.valid || albedo <= 0) return;
    SurfaceStart& start = startAt(column, y);
    setStart<S>(hit.start, albedo, start);
    point.share = share;
    if (!guide.hit || !guide.has_base || albedo <= kLeastSurfaceAlbedo) return;
    point.kind = start.base.all ? SurfaceKind::kDiffuse : SurfaceKind::kMixed;
    SurfacePlace& place = out_.surfaces->place(out_.surfaces->indexOf(column, y));
    place.position = guide.point, place.normal = guide.normal;
    place.footprint = view_.camera.pixelAt(hit.direction) * guide.t;
    place.unoccluded = luminance(start.base.albedo * white) / albedo;
  }

  SurfaceStart& startAt(int column, int y) const {
    const int per_pixel = out_.surfaces->perPixel();
    return (*starts_)[((y - tile_.y0) * (tile_.x1 - tile_.x0) - tile_.x0) * per_pixel + column];
  }

  const PixelContext& view_;
  Tile tile_;
  Frame& out_;
  const Scratch<std::array<SurfaceStart, kMaxTilePoints>> starts_;
};

template <Shading S>
void renderSurfaceTile(const PixelContext& view, Tile tile, const std::function<void(Tile)>& on_tile,
                       std::vector<SurfaceStart>& starts, Frame& out) {
  TilePoints<S> points(view, tile, out);
  forEachPrimaryBlock<S>(view, tile, [&](Tile block, std::span<const PrimaryHit> centres) {
    if (out.surfaces->perPixel() == 1) return points.set(block, centres);
    std::size_t i = 0;
    forEachPixel(block, [&](int x, int y) { points.setJittered(centres[i++], x, y); });
  });
  on_tile(tile);
  points.keepStarts(starts);
}

}  // namespace saccade
