// The sample of a pixel with its SurfaceSamples.
#pragma once

#include "render/pixel.h"
#include "render/scatter.h"

namespace saccade {

inline constexpr float kLeastSurfaceAlbedo = 1e-4f;  // darker surfaces have no SurfaceSamples

// Mean luminance of `spp` paths and of their parts. `base`: the albedo of the diffuse base.
struct ReflectedParts {
  double all = 0, unoccluded = 0, visible = 0, weighed = 0;
};
template <Shading S, int Channels>
ReflectedParts meanReflectedParts(const RenderScene& scene, const EmitterStrengths& strengths,
                                  const PathStart& start, Rgb base, std::uint64_t seed, std::uint32_t pixel,
                                  int spp, int bounces) {
  ReflectedParts sum;
  for (int i = 0; i < spp; ++i) {
    if (i % kPathsAtOnce == kPathsAtOnce - 1) TilePool::yieldToHighPriority();
    DirectParts<Channels> parts;
    const float path =
        traceReflected<S, Channels>(scene, strengths, start, PathSampler(seed, pixel, i), bounces, parts)
            .luminance();
    const float unoccluded = (Color<Channels>(base) * parts.unoccluded).luminance();
    if (!std::isfinite(path + unoccluded)) continue;
    sum.all += path / spp;
    sum.unoccluded += unoccluded / spp;
    sum.visible += (Color<Channels>(base) * parts.visible).luminance() / spp;
    sum.weighed += parts.weighed.luminance() / spp;
  }
  return sum;
}

// What of a surface is seen directly and reflects alike into all directions.
struct DiffuseBase {
  Rgb albedo;        // 0: there is none
  Rgb unoccluded;    // the light that it reflects in closed form
  bool all = false;  // the surface is nothing else
};
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

// From the pixel's centre, of pass 2 alone.
template <Shading S, int Channels>
void renderSurfacePixel(const PixelContext& view, const SeedPlan& seeds, int bounces, int x, int y,
                        Frame& out) {
  const PrimaryHit primary =
      tracePrimary<S>(view.scene, view.strengths, view.camera, static_cast<float>(x), static_cast<float>(y));
  writeFeatures(primary, view.camera, view.prev, x, y, out.g);
  SurfaceSamples& on = *out.surfaces;
  on.kind.at(x, y) = SurfaceKind::kNone;
  out.samples.I2.at(x, y) = out.g.emission.at(x, y);
  if (!primary.valid) return;

  const Guide& guide = primary.guide;
  const float A = out.g.albedo.at(x, y);
  const bool shared = guide.hit && guide.has_base && A > kLeastSurfaceAlbedo;
  const DiffuseBase base = diffuseBaseOf<S>(view, primary.start);
  const int spp = shared ? static_cast<int>(on.paths.at(x, y)) : seeds.spp2;
  const auto light =
      meanReflectedParts<S, Channels>(view.scene, view.strengths, primary.start, base.albedo, seeds.seed2,
                                      static_cast<std::uint32_t>(y * out.width() + x), spp, bounces);
  out.samples.I2.at(x, y) += static_cast<float>(light.all);
  if (!shared) return;

  on.kind.at(x, y) = base.all ? SurfaceKind::kDiffuse : SurfaceKind::kMixed;
  on.x.at(x, y) = guide.point.x, on.y.at(x, y) = guide.point.y, on.z.at(x, y) = guide.point.z;
  on.footprint.at(x, y) = view.camera.pixel * guide.t;
  // Of a diffuse surface the path's own estimate of such light goes: what is left has the least noise. Of a
  // plastic that estimate holds other light too.
  const double direct = base.all ? light.weighed : light.visible;
  on.unoccluded.at(x, y) = luminance(base.unoccluded) / A;
  on.unoccluded_sample.at(x, y) = static_cast<float>(light.unoccluded) / A;
  on.visible_sample.at(x, y) = static_cast<float>(light.visible) / A;
  on.rest.at(x, y) = static_cast<float>(light.all - direct) / A;
}

}  // namespace saccade
