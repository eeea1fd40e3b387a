#include "render/renderer.h"

#include <algorithm>
#include <cmath>

#include "render/surface_pixel.h"
#include "render/surface_points.h"

namespace saccade {
namespace {

template <Shading S, int Channels>
void renderTile(const PixelContext& view, const SeedPlan& seeds, const RenderSettings& settings, Tile tile,
                Frame& out) {
  const auto pixel = settings.jitter ? renderJitteredPixel<S, Channels> : renderPixel<S, Channels>;
  for (int y = tile.y0; y < tile.y1; ++y) {
    TilePool::yieldToHighPriority();
    for (int x = tile.x0; x < tile.x1; ++x) pixel(view, seeds, settings.bounces, x, y, out);
  }
}

template <Shading S>
void renderSurfaceTile(const PixelContext& view, Tile tile, std::vector<SurfaceStart>& starts, Frame& out) {
  const auto pixel = out.surfaces->perPixel() > 1 ? renderJitteredSurface<S> : renderSurface<S>;
  for (int y = tile.y0; y < tile.y1; ++y)
    for (int x = tile.x0; x < tile.x1; ++x) pixel(view, x, y, starts, out);
}

template <Shading S, int Channels>
void renderPathTile(const PixelContext& view, const SeedPlan& seeds, int bounces, Tile tile,
                    const std::vector<SurfaceStart>& starts, Frame& out) {
  for (int y = tile.y0; y < tile.y1; ++y) {
    TilePool::yieldToHighPriority();
    for (int x = tile.x0; x < tile.x1; ++x)
      renderSurfacePaths<S, Channels>(view, seeds, bounces, starts, x, y, out);
  }
}

template <Shading S>
void renderStillRow(const PixelContext& view, std::uint64_t seed, int spp, int bounces, int y, Frame& out,
                    ImageF (&rgb)[3]) {
  for (int x = 0; x < out.width(); ++x) {
    const PrimaryHit primary = tracePrimary<S>(view.scene, view.strengths, view.camera, static_cast<float>(x),
                                               static_cast<float>(y));
    writeFeatures(primary, view.camera, view.prev, x, y, out.g);
    Rgb c = primary.guide.emission;
    if (primary.valid) {
      const auto pixel = static_cast<std::uint32_t>(y * out.width() + x);
      c = c + meanReflected<S, 3>(view.scene, view.strengths, primary.start, seed, pixel, spp, bounces);
    }
    rgb[0].at(x, y) = c.x, rgb[1].at(x, y) = c.y, rgb[2].at(x, y) = c.z;
  }
}

constexpr int kMaxTileEdge = 32;
constexpr double kPieceRays = 20480;  // of a piece: about ten milliseconds, so that other jobs wait no longer

int tileEdge(const SeedPlan& seeds, int bounces) {
  const double pixel_rays = std::max(1.0, (seeds.spp1 + seeds.spp2) * (bounces + 2.0));
  return std::clamp(static_cast<int>(std::sqrt(kPieceRays / pixel_rays)), 1, kMaxTileEdge);
}

}  // namespace

std::chrono::nanoseconds Renderer::render(const Camera& camera, const Camera& prev, const SeedPlan& seeds,
                                          const PoolHandle& pool, Frame& out) {
  strengths_.setTime(out.time);
  out.samples.spp1 = seeds.spp1;
  out.samples.spp2 = seeds.spp2;
  const PixelContext view{*scene_, strengths_, camera, prev};
  const auto tile = withKernel(scene_->shading(), [this]<Shading S>() {
    return settings_.channels == 1 ? renderTile<S, 1> : renderTile<S, 3>;
  });
  return pool.forEachTile(out.width(), out.height(), tileEdge(seeds, settings_.bounces),
                          [&](Tile t) { tile(view, seeds, settings_, t, out); });
}

std::chrono::nanoseconds Renderer::renderSurfaces(const Camera& camera, const Camera& prev,
                                                  const PoolHandle& pool, Frame& out) {
  strengths_.setTime(out.time);
  out.light = strengths_.state();
  starts_.resize(out.surfaces->indexOf(0, out.height()));
  const PixelContext view{*scene_, strengths_, camera, prev};
  const auto tile = withKernel(scene_->shading(), []<Shading S>() { return renderSurfaceTile<S>; });
  return pool.forEachTile(out.width(), out.height(), kMaxTileEdge,
                          [&](Tile t) { tile(view, t, starts_, out); });
}

std::chrono::nanoseconds Renderer::renderPaths(const Camera& camera, const SeedPlan& seeds,
                                               const PoolHandle& pool, Frame& out) {
  out.samples.spp1 = seeds.spp1;
  out.samples.spp2 = seeds.spp2;
  const PixelContext view{*scene_, strengths_, camera, camera};
  const auto tile = withKernel(scene_->shading(), [this]<Shading S>() {
    return settings_.channels == 1 ? renderPathTile<S, 1> : renderPathTile<S, 3>;
  });
  return pool.forEachTile(out.width(), out.height(), tileEdge(seeds, settings_.bounces),
                          [&](Tile t) { tile(view, seeds, settings_.bounces, t, starts_, out); });
}

void Renderer::renderStill(const Camera& camera, std::uint64_t seed, int spp, const PoolHandle& pool,
                           Frame& out, ImageF (&rgb)[3]) {
  strengths_.setTime(out.time);
  const PixelContext view{*scene_, strengths_, camera, camera};
  const auto row = withKernel(scene_->shading(), []<Shading S>() { return renderStillRow<S>; });
  pool.forEachRow(out.height(), [&](int y) { row(view, seed, spp, settings_.bounces, y, out, rgb); });
}

}  // namespace saccade
