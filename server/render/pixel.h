// The samples of one pixel.
#pragma once

#include <array>
#include <cmath>

#include "base/tile_pool.h"
#include "render/gbuffer_pass.h"
#include "render/seed_plan.h"
#include "render/sub_pixel.h"

namespace saccade {

inline constexpr int kPathsAtOnce = 16;       // paths between two chances for urgent work
inline constexpr float kLeastAlbedo = 1e-3f;  // of a point that shows illumination, over the pixel's average

// The mean reflected radiance of `spp` paths. It is finite: a path without a finite estimate counts as black.
// Such a path is rare: its light sample is the very point that it lights, or its lamp is too bright for
// floats.
template <Shading S, int Channels>
Rgb meanReflected(const RenderScene& scene, const EmitterStrengths& strengths, const PathStart& start,
                  std::uint64_t seed, std::uint32_t pixel, int spp, int bounces) {
  Vec3d sum;
  for (int i = 0; i < spp; ++i) {
    if (i % kPathsAtOnce == kPathsAtOnce - 1) TilePool::yieldToHighPriority();
    NoParts none;
    const Rgb path =
        traceReflected<S, Channels>(scene, strengths, start, PathSampler(seed, pixel, i), bounces, none)
            .rgb();
    if (std::isfinite(luminance(path))) sum = sum + toDouble(path);
  }
  return spp > 0 ? toFloat(sum / static_cast<double>(spp)) : Rgb{};
}

struct PixelContext {
  const RenderScene& scene;
  const EmitterStrengths& strengths;
  const Camera &camera, &prev;
};

// The samples of both passes. All paths start at the centre of the pixel.
template <Shading S, int Channels>
void renderPixel(const PixelContext& view, const SeedPlan& seeds, int bounces, int x, int y, Frame& out) {
  const PrimaryHit primary =
      tracePrimary<S>(view.scene, view.strengths, view.camera, static_cast<float>(x), static_cast<float>(y));
  writeFeatures(primary, view.camera, view.prev, x, y, out.g);
  const auto pixel = static_cast<std::uint32_t>(y * out.width() + x);
  const auto pass = [&](std::uint64_t seed, int spp) {
    if (spp == 0) return 0.f;
    const float emission = out.g.emission.at(x, y);
    if (!primary.valid) return emission;
    return emission + luminance(meanReflected<S, Channels>(view.scene, view.strengths, primary.start, seed,
                                                           pixel, spp, bounces));
  };
  out.samples.I1.at(x, y) = pass(seeds.seed1, seeds.spp1);
  out.samples.I2.at(x, y) = pass(seeds.seed2, seeds.spp2);
}

// The samples of both passes. The paths of each pass start at its own point of the pixel.
// A sample is scaled as if it came off the average albedo of the pixel. For the filter smooths illumination,
// and the average is without noise [paper, 5.5]. Guides are of the centre.
template <Shading S, int Channels>
void renderJitteredPixel(const PixelContext& view, const SeedPlan& seeds, int bounces, int x, int y,
                         Frame& out) {
  const auto hitAt = [&](Vec2 offset) {
    return tracePrimary<S>(view.scene, view.strengths, view.camera, static_cast<float>(x) + offset.x,
                           static_cast<float>(y) + offset.y);
  };
  writeFeatures(hitAt({}), view.camera, view.prev, x, y, out.g);
  std::array<PrimaryHit, kSubPixels> hits;
  std::array<float, kSubPixels> albedo;
  float A = 0, E = 0;
  for (std::size_t i = 0; i < kSubPixels; ++i) {
    hits[i] = hitAt(kSubPixelOffsets[i]);
    albedo[i] = luminance(hits[i].guide.albedo);
    A += albedo[i] / kSubPixels, E += luminance(hits[i].guide.emission) / kSubPixels;
  }
  out.g.albedo.at(x, y) = A, out.g.emission.at(x, y) = E;
  const auto pixel = static_cast<std::uint32_t>(y * out.width() + x);
  const auto pass = [&](std::uint64_t seed, int spp, FrameIndex jitter) {
    if (spp == 0) return 0.f;
    if (A <= 0) return E;
    std::size_t i = jitter % kSubPixels;
    while (albedo[i] < kLeastAlbedo * A) i = (i + 1) % kSubPixels;  // a black point shows no illumination
    const Rgb light =
        meanReflected<S, Channels>(view.scene, view.strengths, hits[i].start, seed, pixel, spp, bounces);
    return E + luminance(light) / albedo[i] * A;
  };
  out.samples.I1.at(x, y) = pass(seeds.seed1, seeds.spp1, seeds.jitter1);
  out.samples.I2.at(x, y) = pass(seeds.seed2, seeds.spp2, seeds.jitter2);
}

}  // namespace saccade
