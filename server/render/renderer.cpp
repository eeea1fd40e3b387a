#include "render/renderer.h"

#include <algorithm>
#include <cmath>

#include "render/tile_renderer.h"
#include "render/tiles/pairs.h"
#include "render/tiles/replays.h"
#include "render/tiles/surface_pixel.h"
#include "render/tiles/surface_points.h"

namespace saccade {
namespace {

// One picture in colour: the sums of a tile's paths.
template <Shading S>
void renderStillTile(const PixelContext& view, const SeedPlan& seeds, int bounces, Tile tile, Frame& out,
                     ImageF (&rgb)[3]) {
  const Scratch<std::array<Vec3d, kMaxTileEdge * kMaxTileEdge>> sums;
  const auto owner = [&](int x, int y) {
    return static_cast<std::uint32_t>((y - tile.y0) * kMaxTileEdge + x - tile.x0);
  };
  const auto onPath = [&](std::uint32_t of, const PathResults<3>& found, std::uint32_t slot) {
    const Rgb path = found.radiance.at(slot).rgb();
    if (std::isfinite(luminance(path))) (*sums)[of] = (*sums)[of] + toDouble(path);
  };
  const Tracing tracing{view.now.scene, bounces, {}};
  PathRun<S, 3, false, decltype(onPath)> run(tracing, onPath);
  forEachPixel(tile, [&](int x, int y) { (*sums)[owner(x, y)] = {}; });
  const auto forEachPath = [&](const auto& f) {
    forEachSample(seeds, 1, [&](const PixelSequence& numbers, std::uint32_t i) {
      f([&](int x, int y) { return NewPath{numbers.of(x, y, i), owner(x, y)}; });
    });
  };
  addPaths<S>(view, tile, out.g, run, forEachPath, [&](int x, int y, Rgb E) {
    rgb[0].at(x, y) = E.x, rgb[1].at(x, y) = E.y, rgb[2].at(x, y) = E.z;
  });
  forEachPixel(tile, [&](int x, int y) {
    const Rgb c = seeds.spp2 > 0 ? toFloat((*sums)[owner(x, y)] / static_cast<double>(seeds.spp2)) : Rgb{};
    rgb[0].at(x, y) += c.x, rgb[1].at(x, y) += c.y, rgb[2].at(x, y) += c.z;
  });
}

constexpr double kPieceRays = 20480;  // of a piece: few milliseconds, so that other jobs wait no longer

int tileEdge(int spp, int bounces) {
  const double pixel_rays = std::max(1.0, spp * (bounces + 2.0));
  return std::clamp(static_cast<int>(std::sqrt(kPieceRays / pixel_rays)), 1, kMaxTileEdge);
}

std::uint32_t mostPaths(const SurfaceSamples& on) {
  std::uint32_t most = 0;
  for (int y = 0; y < on.height(); ++y)
    for (const SurfacePoint& p : on.row(y)) most = std::max(most, p.paths);
  return most;
}

}  // namespace

std::chrono::nanoseconds Renderer::render(const PixelContext& view, const SeedPlan& seeds,
                                          const PoolHandle& pool, Frame& out) {
  out.samples.spp1 = seeds.spp1;
  out.samples.spp2 = seeds.spp2;
  showBodies(view, out.g);
  // Where all stands, centres of pixels stay where they are, to the last bit.
  const bool along_motion = seeds.along_motion && !out.stands;
  const TileRenderer tile = tileRenderer(view.now.scene.still(), settings_, along_motion, seeds.reconnects);
  return pool.forEachTile(out.width(), out.height(), tileEdge(seeds.spp1 + seeds.spp2, settings_.bounces),
                          [&](Tile t) { tile(view, seeds, settings_.bounces, t, out); });
}

SurfaceFrame Renderer::renderSurfaces(const PixelContext& view, const PoolHandle& pool, Frame& out,
                                      const OnTile& on_tile) {
  const RenderScene& scene = view.now.scene.still();
  showBodies(view, out.g);
  out.light = view.now.scene.strengths().state();
  const Shading has = scene.shading();
  const bool plain_only =
      has.diffuseOnly() && !has.extras && view.now.camera.isPlain() && out.surfaces->perPixel() == 1;
  if (starts().anyOfOthers() || scene.analyticLight().groups() > 0) current_ = 1 - current_;
  shadows_.next(scene, out.surfaces->indexOf(0, out.height()));
  starts().resize(out.surfaces->indexOf(0, out.height()), plain_only, view.now.scene.deformed());
  moved_ = MovedBodies(view.now.scene, view.before.scene);
  changing_.emplace(view.now.scene, view.before.scene, moved_);
  sliding_.next(view.now.scene, view.before.scene);
  const FrameMotion motion = this->motion();
  const auto tile = withKernel(has, []<Shading S>() { return renderSurfaceTile<S>; });
  const auto time = pool.forEachTile(out.width(), out.height(), kMaxTileEdge,
                                     [&](Tile t) { tile(view, motion, t, on_tile, starts(), out); });
  out.surfaces->summarize(starts().any(), starts().anyOfOthers(), starts().anyNearShadow());
  return {out, scene, time};
}

std::chrono::nanoseconds Renderer::renderPaths(const PosedView& view, const SeedPlan& seeds,
                                               const SurfaceFrame& next, const BounceGrid* known,
                                               const PoolHandle& pool) {
  Frame& out = next.frame;
  out.samples.spp1 = seeds.spp1;
  out.samples.spp2 = seeds.spp2;
  const Camera& camera = view.camera;
  const Tracing tracing{view.scene,
                        settings_.bounces,
                        {known, camera.origin, camera.pixel},
                        view.scene.still().deltaLamps().getRays(),
                        true,
                        moved_.any() ? &moved_ : nullptr};
  if (moved_.any()) touched_.reset(out.surfaces->indexOf(0, out.height()), mostPaths(*out.surfaces));
  const auto tile = withKernel(view.scene.still().shading(), [this]<Shading S>() {
    return settings_.channels == 1 ? renderPathTile<S, 1> : renderPathTile<S, 3>;
  });
  return pool.forEachTile(out.width(), out.height(), tileEdge(seeds.spp1 + seeds.spp2, settings_.bounces),
                          [&](Tile t) { tile(seeds, tracing, t, starts(), touched_, out); });
}

std::chrono::nanoseconds Renderer::renderReplays(const PixelContext& view, const SeedPlan& seeds,
                                                 const PoolHandle& pool, Frame& out) {
  std::vector<float>& changes = out.surfaces->changes();
  if (!moved_.any() || view.now.scene.strengths().state() != view.before.scene.strengths().state())
    return changes.clear(), std::chrono::nanoseconds{0};
  changes.assign(out.surfaces->indexOf(0, out.height()), 0);
  const Camera& camera = view.now.camera;
  const Tracing tracing{view.before.scene,
                        settings_.bounces,
                        {nullptr, camera.origin, camera.pixel},
                        view.before.scene.still().deltaLamps().getRays(),
                        true,
                        nullptr,
                        true};
  const auto tile = withKernel(view.now.scene.still().shading(), [this]<Shading S>() {
    return settings_.channels == 1 ? renderReplayTile<S, 1> : renderReplayTile<S, 3>;
  });
  return pool.forEachTile(out.width(), out.height(), tileEdge(seeds.spp2, settings_.bounces),
                          [&](Tile t) { tile(view, moved_, touched_, seeds, tracing, t, starts(), out); });
}

std::chrono::nanoseconds Renderer::renderPairs(const PixelContext& view, const SeedPlan& seeds,
                                               const Frame& before, const BounceGrid* known,
                                               const PoolHandle& pool, Frame& out) {
  if (!out.pairs) out.pairs = std::make_unique<PairSamples>(out.width(), out.height());
  const Camera& camera = view.now.camera;
  const KnownBounces bounces{known, camera.origin, camera.pixel};
  const bool deltas_apart = view.now.scene.still().deltaLamps().getRays();
  const PairSides sides{
      {out, starts(), {view.now.scene, settings_.bounces, bounces, deltas_apart, true}},
      {before, startsBefore(), {view.before.scene, settings_.bounces, bounces, deltas_apart, true}},
      {seeds.stream, seeds.frame2}};
  const Shading has = view.now.scene.still().shading();
  const int edge = tileEdge(2 * seeds.spp2, settings_.bounces);
  const auto replay = withKernel(has, [this]<Shading S>() {
    return settings_.channels == 1 ? renderPairTile<S, 1> : renderPairTile<S, 3>;
  });
  const auto add = withKernel(has, [this]<Shading S>() {
    return settings_.channels == 1 ? renderMorePairsTile<S, 1> : renderMorePairsTile<S, 3>;
  });
  auto time =
      pool.forEachTile(out.width(), out.height(), edge, [&](Tile tile) { replay(sides, tile, *out.pairs); });
  time += planMorePairs(out, before, pool, *out.pairs);
  return time + pool.forEachTile(out.width(), out.height(), edge,
                                 [&](Tile tile) { add(sides, tile, out.samples, *out.pairs); });
}

std::chrono::nanoseconds Renderer::traceShadows(const PixelContext& view, int spp, Frame& now,
                                                const Frame& before, const PoolHandle& pool) {
  return shadows_.trace({view.now.scene, *now.surfaces, starts()},
                        {view.before.scene, *before.surfaces, startsBefore()}, spp, pool,
                        now.surfaces->shadows());
}

void Renderer::renderStill(const PixelContext& view, const SeedPlan& seeds, const PoolHandle& pool,
                           Frame& out, ImageF (&rgb)[3]) {
  const auto tile =
      withKernel(view.now.scene.still().shading(), []<Shading S>() { return renderStillTile<S>; });
  pool.forEachTile(out.width(), out.height(), tileEdge(seeds.spp2, settings_.bounces),
                   [&](Tile t) { tile(view, seeds, settings_.bounces, t, out, rgb); });
}

}  // namespace saccade
