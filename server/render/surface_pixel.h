// The sample of a pixel with its SurfaceSamples.
#pragma once

#include "render/pixel.h"
#include "render/scatter.h"
#include "render/surface_start.h"

namespace saccade {

inline constexpr float kLeastSurfaceAlbedo = 1e-4f;  // darker surfaces have no SurfaceSamples

// Mean luminance of `spp` paths and of their parts. `base`: the albedo of the diffuse base.
struct ReflectedParts {
  double all = 0, unoccluded = 0, visible = 0, weighed = 0;
  BounceSample bounce;  // of the last path that has one
};
template <Shading S, int Channels>
ReflectedParts meanReflectedParts(const RenderScene& scene, const EmitterStrengths& strengths,
                                  const KnownBounces& known, const PathStart& start, Rgb base,
                                  std::uint64_t seed, std::uint32_t pixel, int spp, int bounces) {
  ReflectedParts sum;
  for (int i = 0; i < spp; ++i) {
    if (i % kPathsAtOnce == kPathsAtOnce - 1) TilePool::yieldToHighPriority();
    PathParts<Channels> parts(known);
    const float path =
        traceReflected<S, Channels>(scene, strengths, start, PathSampler(seed, pixel, i), bounces, parts)
            .luminance();
    const float unoccluded = (Color<Channels>(base) * parts.unoccluded).luminance();
    if (!std::isfinite(path + unoccluded)) continue;
    sum.all += path / spp;
    sum.unoccluded += unoccluded / spp;
    sum.visible += (Color<Channels>(base) * parts.visible).luminance() / spp;
    sum.weighed += parts.weighed.luminance() / spp;
    if (parts.tail.sample().cell != 0) sum.bounce = parts.tail.sample();
  }
  return sum;
}

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

// The features of a pixel, from its centre, and where its samples will lie.
template <Shading S>
void renderSurface(const PixelContext& view, int x, int y, SurfaceStart& start, Frame& out) {
  const PrimaryHit primary =
      tracePrimary<S>(view.scene, view.strengths, view.camera, static_cast<float>(x), static_cast<float>(y));
  writeFeatures(primary, view.camera, view.prev, x, y, out.g);
  start.valid = primary.valid;
  SurfaceSamples& on = *out.surfaces;
  on.kind.at(x, y) = SurfaceKind::kNone;
  if (!primary.valid) return;
  start.path = primary.start;
  start.base = diffuseBaseOf<S>(view, primary.start);
  const Guide& guide = primary.guide;
  const float A = out.g.albedo.at(x, y);
  if (!guide.hit || !guide.has_base || A <= kLeastSurfaceAlbedo) return;
  on.kind.at(x, y) = start.base.all ? SurfaceKind::kDiffuse : SurfaceKind::kMixed;
  on.x.at(x, y) = guide.point.x, on.y.at(x, y) = guide.point.y, on.z.at(x, y) = guide.point.z;
  on.footprint.at(x, y) = view.camera.pixel * guide.t;
  on.unoccluded.at(x, y) = luminance(start.base.unoccluded) / A;
}

// Its samples, of pass 2 alone.
template <Shading S, int Channels>
void renderSurfacePaths(const PixelContext& view, const SeedPlan& seeds, int bounces,
                        const SurfaceStart& start, int x, int y, Frame& out) {
  SurfaceSamples& on = *out.surfaces;
  const bool shared = on.kind.at(x, y) != SurfaceKind::kNone;
  const int spp = !start.valid ? 0 : shared ? static_cast<int>(on.paths.at(x, y)) : seeds.spp2;
  const auto pixel = static_cast<std::uint32_t>(y * out.width() + x);
  const KnownBounces known{on.bounces, view.camera.origin, view.camera.pixel};
  const auto light = meanReflectedParts<S, Channels>(view.scene, view.strengths, known, start.path,
                                                     start.base.albedo, seeds.seed2, pixel, spp, bounces);
  on.bounce.at(x, y) = light.bounce;
  out.samples.I2.at(x, y) = out.g.emission.at(x, y) + static_cast<float>(light.all);
  if (!shared) return;
  // Of a diffuse surface the path's own estimate of such light goes: what is left has the least noise. Of a
  // plastic that estimate holds other light too.
  const double direct = start.base.all ? light.weighed : light.visible;
  const float A = out.g.albedo.at(x, y);
  on.unoccluded_sample.at(x, y) = static_cast<float>(light.unoccluded) / A;
  on.visible_sample.at(x, y) = static_cast<float>(light.visible) / A;
  on.rest.at(x, y) = static_cast<float>(light.all - direct) / A;
}

}  // namespace saccade
