// The points that a pixel shows, as SurfaceSamples has them.
#pragma once

#include "render/scatter.h"
#include "render/sub_pixels_shown.h"
#include "render/surface_start.h"
#include "render/tile_samples.h"

namespace saccade {

inline constexpr float kLeastSurfaceAlbedo = 1e-4f;  // darker surfaces share no light

inline LitPoint litPoint(const PathStart& start) {
  return {start.surface.point, start.surface.shading_normal, start.surface.geometric_normal};
}

// `white`: what a white surface would reflect of the light in closed form.
template <Shading S>
DiffuseBase diffuseBaseOf(const PathStart& start, Rgb white) {
  const Surface& s = start.surface;
  const Scatter<S> scatter(s, start.direction);
  if (!scatter.hasBase() || s.opacity < 1) return {};
  const Rgb albedo = scatter.diffuseAlbedo();
  return {albedo, albedo * white, scatter.isDiffuse()};
}

// The point that a ray has found. `share`: of the pixel's albedo.
template <Shading S>
void setPoint(const PixelContext& view, const PrimaryHit& hit, Rgb white, float share, SurfaceStart& start,
              SurfacePoint& out) {
  out = {};
  const Guide& guide = hit.guide;
  if (!hit.valid || luminance(guide.albedo) <= 0) return;
  start.path = hit.start;
  start.base = diffuseBaseOf<S>(hit.start, white);
  start.albedo = luminance(guide.albedo);
  out.share = share;
  if (!guide.hit || !guide.has_base || start.albedo <= kLeastSurfaceAlbedo) return;
  out.kind = start.base.all ? SurfaceKind::kDiffuse : SurfaceKind::kMixed;
  out.position = guide.point;
  out.normal = guide.normal;
  out.footprint = view.camera.pixel * guide.t;
  out.unoccluded = luminance(start.base.unoccluded) / start.albedo;
}

// The features of a block's pixels, from their centres, and their one point each.
template <Shading S>
void setSurfaces(const PixelContext& view, Tile block, std::span<const PrimaryHit> centres,
                 std::vector<SurfaceStart>& starts, Frame& out) {
  std::array<LitPoint, kMostPoints> points;
  std::array<Rgb, kMostPoints> white;
  for (std::size_t i = 0; i < centres.size(); ++i) points[i] = litPoint(centres[i].start);
  view.scene.analyticLight().at(points, view.strengths, std::span(white).first(centres.size()));
  std::size_t i = 0;
  forEachPixel(block, [&](int x, int y) {
    writeFeatures(centres[i], view.camera, view.prev, x, y, out.g);
    setPoint<S>(view, centres[i], white[i], 1, starts[out.surfaces->indexOf(x, y)], out.surfaces->at(x, y));
    ++i;
  });
}

// The same for one pixel, with a point for each surface that the pixel shows, at the centre of the pixel
// where that shows it, too. Albedo and emission are means over the pixel. Guides are of the centre.
template <Shading S>
void setJitteredSurface(const PixelContext& view, const PrimaryHit& centre, int x, int y,
                        std::vector<SurfaceStart>& starts, Frame& out) {
  writeFeatures(centre, view.camera, view.prev, x, y, out.g);
  const SubPixels<S> shown(view, x, y);
  const float A = out.g.albedo.at(x, y) = shown.albedo();
  out.g.emission.at(x, y) = shown.emission();
  for (SurfacePoint& p : out.surfaces->of(x, y)) p = {};
  if (A <= 0) return;
  int column = x * out.surfaces->perPixel();
  shown.forEachSurface([&](const PrimaryHit& hit, float albedo) {
    const bool central =
        isOneSurface(hit, centre, view.camera.pixel) && luminance(centre.guide.albedo) >= kLeastAlbedo * A;
    const PrimaryHit& shows = central ? centre : hit;
    const Rgb white = view.scene.analyticLight().at(litPoint(shows.start), view.strengths);
    setPoint<S>(view, shows, white, albedo / A, starts[out.surfaces->indexOf(column, y)],
                out.surfaces->at(column, y));
    ++column;
  });
}

template <Shading S>
void renderSurfaceTile(const PixelContext& view, Tile tile, std::vector<SurfaceStart>& starts, Frame& out) {
  forEachPrimaryBlock<S>(view, tile, [&](Tile block, std::span<const PrimaryHit> centres) {
    if (out.surfaces->perPixel() == 1) return setSurfaces<S>(view, block, centres, starts, out);
    std::size_t i = 0;
    forEachPixel(block, [&](int x, int y) { setJitteredSurface<S>(view, centres[i++], x, y, starts, out); });
  });
}

}  // namespace saccade
