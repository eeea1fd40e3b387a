#include "render/render_pixels.h"

#include "render/tile_renderer.h"

namespace saccade {
namespace {

constexpr int kEdge = 16;  // of a piece of work, pixels

// Calls f(Tile) for the tile if all its pixels are wanted, or else for each run of them in a row.
template <class F>
void forEachWanted(Tile tile, const Image<int>& wanted, const F& f) {
  bool all = true;
  forEachPixel(tile, [&](int x, int y) { all &= wanted.at(x, y) != 0; });
  if (all) return f(tile);
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x = tile.x0; x < tile.x1; ++x) {
      const int first = x;
      while (x < tile.x1 && wanted.at(x, y)) ++x;
      if (x > first) f(Tile{first, y, x, y + 1});
    }
  }
}

}  // namespace

std::chrono::nanoseconds renderPixels(const RenderSettings& settings, const PixelContext& view,
                                      const SeedPlan& seeds, const Image<int>& wanted, const PoolHandle& pool,
                                      Frame& out) {
  out.samples.spp1 = seeds.spp1;
  out.samples.spp2 = seeds.spp2;
  showBodies(view, out.g);
  const TileRenderer render = tileRenderer(view.now.scene.still(), settings, false, seeds.reconnects);
  return pool.forEachTile(out.width(), out.height(), kEdge, [&](Tile tile) {
    forEachWanted(tile, wanted, [&](Tile part) { render(view, seeds, settings.bounces, part, out); });
  });
}

}  // namespace saccade
