#include "render/renderer.h"

#include <cmath>
#include <limits>

#include "render/gbuffer_pass.h"
#include "render/path_tracer.h"

namespace saccade {
namespace {

// Mean reflected radiance of `spp` paths, finite: a path whose estimate is not (a light sample on the very
// point it lights, a lamp beyond what floats can weigh) counts as dark.
template <Shading S, int Channels>
Rgb meanReflected(const RenderScene& scene, const EmitterStrengths& strengths, const PathStart& start,
                  std::uint64_t seed, std::uint32_t pixel, int spp, int bounces) {
  Vec3d sum;
  for (int i = 0; i < spp; ++i) {
    const Rgb path =
        traceReflected<S, Channels>(scene, strengths, start, PathSampler(seed, pixel, i), bounces).rgb();
    if (std::isfinite(luminance(path))) sum = sum + toDouble(path);
  }
  return spp > 0 ? toFloat(sum / static_cast<double>(spp)) : Rgb{};
}

template <Shading S, int Channels>
void renderTile(const RenderScene& scene, const EmitterStrengths& strengths, const Camera& camera,
                const Camera& prev, const SeedPlan& seeds, int bounces, Tile tile, Frame& out) {
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x = tile.x0; x < tile.x1; ++x) {
      const PrimaryHit primary = tracePrimary<S>(scene, strengths, camera, prev, x, y, out.g);
      const auto pixel = static_cast<std::uint32_t>(y * out.width() + x);
      const auto pass = [&](std::uint64_t seed, int spp) {
        if (spp == 0) return 0.f;
        const float emission = out.g.emission.at(x, y);
        if (!primary.valid) return emission;
        return emission + luminance(meanReflected<S, Channels>(scene, strengths, primary.start, seed, pixel,
                                                               spp, bounces));
      };
      out.samples.I1.at(x, y) = pass(seeds.seed1, seeds.spp1);
      out.samples.I2.at(x, y) = pass(seeds.seed2, seeds.spp2);
    }
  }
}

template <Shading S>
void renderStillRow(const RenderScene& scene, const EmitterStrengths& strengths, const Camera& camera,
                    std::uint64_t seed, int spp, int bounces, int y, Frame& out, ImageF (&rgb)[3]) {
  for (int x = 0; x < out.width(); ++x) {
    const PrimaryHit primary = tracePrimary<S>(scene, strengths, camera, camera, x, y, out.g);
    Rgb c = primary.emission;
    if (primary.valid) {
      const auto pixel = static_cast<std::uint32_t>(y * out.width() + x);
      c = c + meanReflected<S, 3>(scene, strengths, primary.start, seed, pixel, spp, bounces);
    }
    rgb[0].at(x, y) = c.x, rgb[1].at(x, y) = c.y, rgb[2].at(x, y) = c.z;
  }
}

// call.operator()<S>() with the least shading that holds the scene.
template <class Call>
auto withShading(const RenderScene& scene, Call call) {
  switch (scene.shading()) {
    case Shading::kDiffuse:
      return call.template operator()<Shading::kDiffuse>();
    case Shading::kTexturedDiffuse:
      return call.template operator()<Shading::kTexturedDiffuse>();
    case Shading::kAll:
      break;
  }
  return call.template operator()<Shading::kAll>();
}

}  // namespace

std::chrono::nanoseconds Renderer::render(const Camera& camera, const Camera& prev, const SeedPlan& seeds,
                                          Frame& out) {
  strengths_.setTime(out.time);
  out.samples.spp1 = seeds.spp1;
  out.samples.spp2 = seeds.spp2;
  const auto tile = withShading(
      *scene_, [this]<Shading S>() { return channels_ == 1 ? renderTile<S, 1> : renderTile<S, 3>; });
  return pool_.forEachTile(out.width(), out.height(),
                           [&](Tile t) { tile(*scene_, strengths_, camera, prev, seeds, bounces_, t, out); });
}

void Renderer::renderStill(const Camera& camera, std::uint64_t seed, int spp, Frame& out, ImageF (&rgb)[3]) {
  strengths_.setTime(out.time);
  const auto row = withShading(*scene_, []<Shading S>() { return renderStillRow<S>; });
  pool_.forEachRow(out.height(),
                   [&](int y) { row(*scene_, strengths_, camera, seed, spp, bounces_, y, out, rgb); });
}

std::vector<Vec3> probePoints(const RenderScene& scene, const Pose& T_world_camera, double fov_x_deg) {
  constexpr int kWidth = 64, kHeight = 48;
  const Camera camera(T_world_camera, fov_x_deg, kWidth, kHeight);
  std::vector<Vec3> points;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const Vec3 d = camera.direction(static_cast<float>(x), static_cast<float>(y));
      const Hit hit = scene.geometry().intersect({camera.origin, d, std::numeric_limits<float>::infinity()});
      if (hit.valid) points.push_back(camera.origin + d * hit.t);
    }
  }
  return points;
}

}  // namespace saccade
