// The points that a pixel shows, as SurfaceSamples has them.
#pragma once

#include "render/pixel.h"
#include "render/scatter.h"
#include "render/sub_pixels_shown.h"
#include "render/surface_start.h"

namespace saccade {

inline constexpr float kLeastSurfaceAlbedo = 1e-4f;  // darker surfaces share no light

template <Shading S>
DiffuseBase diffuseBaseOf(const PixelContext& view, const PathStart& start) {
  const Surface& s = start.surface;
  const Scatter<S> scatter(s, start.direction);
  if (!scatter.hasBase() || s.opacity < 1) return {};
  const Rgb albedo = scatter.diffuseAlbedo();
  return {
      albedo,
      albedo * view.scene.analyticLight().at(s.point, s.shading_normal, s.geometric_normal, view.strengths),
      scatter.isDiffuse()};
}

// The point that a ray has found. `share`: of the pixel's albedo.
template <Shading S>
void setPoint(const PixelContext& view, const PrimaryHit& hit, float share, SurfaceStart& start,
              SurfacePoint& out) {
  out = {};
  const Guide& guide = hit.guide;
  if (!hit.valid || luminance(guide.albedo) <= 0) return;
  start.path = hit.start;
  start.base = diffuseBaseOf<S>(view, hit.start);
  start.albedo = luminance(guide.albedo);
  out.share = share;
  if (!guide.hit || !guide.has_base || start.albedo <= kLeastSurfaceAlbedo) return;
  out.kind = start.base.all ? SurfaceKind::kDiffuse : SurfaceKind::kMixed;
  out.position = guide.point;
  out.normal = guide.normal;
  out.footprint = view.camera.pixel * guide.t;
  out.unoccluded = luminance(start.base.unoccluded) / start.albedo;
}

// The features of a pixel, from its centre, and its one point.
template <Shading S>
void renderSurface(const PixelContext& view, int x, int y, std::vector<SurfaceStart>& starts, Frame& out) {
  const PrimaryHit primary =
      tracePrimary<S>(view.scene, view.strengths, view.camera, static_cast<float>(x), static_cast<float>(y));
  writeFeatures(primary, view.camera, view.prev, x, y, out.g);
  setPoint<S>(view, primary, 1, starts[out.surfaces->indexOf(x, y)], out.surfaces->at(x, y));
}

// The same with a point for each surface that the pixel shows, at the centre of the pixel where that shows
// it, too. Albedo and emission are means over the pixel. Guides are of the centre.
template <Shading S>
void renderJitteredSurface(const PixelContext& view, int x, int y, std::vector<SurfaceStart>& starts,
                           Frame& out) {
  const PrimaryHit centre =
      tracePrimary<S>(view.scene, view.strengths, view.camera, static_cast<float>(x), static_cast<float>(y));
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
    setPoint<S>(view, central ? centre : hit, albedo / A, starts[out.surfaces->indexOf(column, y)],
                out.surfaces->at(column, y));
    ++column;
  });
}

}  // namespace saccade
