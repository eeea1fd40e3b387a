// The samples of a pixel with SurfaceSamples.
#pragma once

#include "render/pixel.h"
#include "render/scatter.h"
#include "render/surface_start.h"

namespace saccade {

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

// The paths of one point. Returns the light that leaves it, over its albedo.
template <Shading S, int Channels>
double renderPointPaths(const PixelContext& view, const KnownBounces& known, const SurfaceStart& start,
                        std::uint64_t seed, std::uint32_t index, int spp, int bounces, SurfacePoint& out) {
  const auto light = meanReflectedParts<S, Channels>(view.scene, view.strengths, known, start.path,
                                                     start.base.albedo, seed, index, spp, bounces);
  // Of a diffuse surface the path's own estimate of such light goes: what is left has the least noise. Of a
  // plastic that estimate holds other light too.
  const double direct = start.base.all ? light.weighed : light.visible;
  out.unoccluded_sample = static_cast<float>(light.unoccluded) / start.albedo;
  out.visible_sample = static_cast<float>(light.visible) / start.albedo;
  out.rest = static_cast<float>(light.all - direct) / start.albedo;
  out.bounce = light.bounce;
  return light.all / start.albedo;
}

// The samples of a pixel's points, of pass 2 alone.
template <Shading S, int Channels>
void renderSurfacePaths(const PixelContext& view, const SeedPlan& seeds, int bounces,
                        const std::vector<SurfaceStart>& starts, int x, int y, Frame& out) {
  SurfaceSamples& on = *out.surfaces;
  const KnownBounces known{on.bounces, view.camera.origin, view.camera.pixel};
  double I = out.g.emission.at(x, y);
  for (int column = x * on.perPixel(); column < (x + 1) * on.perPixel(); ++column) {
    SurfacePoint& p = on.at(column, y);
    const std::size_t i = on.indexOf(column, y);
    if (p.share <= 0) continue;
    I += renderPointPaths<S, Channels>(view, known, starts[i], seeds.seed2, static_cast<std::uint32_t>(i),
                                       static_cast<int>(p.paths), bounces, p) *
         p.share * out.g.albedo.at(x, y);
  }
  out.samples.I2.at(x, y) = static_cast<float>(I);
}

}  // namespace saccade
