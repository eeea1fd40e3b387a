// The samples of a tile whose surfaces keep their random numbers, for SeedPlan::correlatedAlongMotion.
#pragma once

#include "render/tiles/tile_samples.h"

namespace saccade {

// Where the surface is seen that the centre of pixelBefore() showed: it moves as the surface at (x, y) does,
// to the first order. It is within half a pixel of (x, y), or else was outside the picture; then it is (x,
// y).
inline Vec2 placeOfBefore(const GBuffer& g, int x, int y) {
  constexpr float kFarthest = 0.501f;  // as rounding allows
  const PixelPlace p = pixelBefore(g, x, y);
  const Vec2 centre{static_cast<float>(x), static_cast<float>(y)};
  const Vec2 place{static_cast<float>(p.x) - g.motion_x.at(x, y),
                   static_cast<float>(p.y) - g.motion_y.at(x, y)};
  const bool inside = std::abs(place.x - centre.x) < kFarthest && std::abs(place.y - centre.y) < kFarthest;
  return inside ? place : centre;
}

// Calls f(x, y, hit) for each pixel of a tile whose features `g` has, with what is seen at placeOfBefore().
template <Shading S>
void forEachBefore(const PixelContext& view, Tile tile, const GBuffer& g, const auto& f) {
  std::array<Vec2, kMostPoints> points;
  std::array<PrimaryHit, kMostPoints> hits;
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x0 = tile.x0; x0 < tile.x1; x0 += int{kMostPoints}) {
      const auto count = std::min(kMostPoints, static_cast<std::size_t>(tile.x1 - x0));
      for (std::size_t i = 0; i < count; ++i) points[i] = placeOfBefore(g, x0 + static_cast<int>(i), y);
      tracePrimaries<S>(view, std::span(points).first(count), std::span(hits).first(count));
      for (std::size_t i = 0; i < count; ++i) f(x0 + static_cast<int>(i), y, hits[i]);
    }
  }
}

// Paths of pass 2 start at the centre of the pixel. Those of pass 1 start at the point that pass 2 had one
// frame ago, with the numbers that it had there. They are scaled as if they came off the albedo of the
// centre.
template <Shading S, int C>
void renderTileAlongMotion(const PixelContext& view, const SeedPlan& seeds, int bounces, Tile tile,
                           Frame& out) {
  TileSums sums(tile, seeds);
  std::array<float, 2 * kMaxTileEdge * kMaxTileEdge> scale{};  // by owner; of pass 1
  const auto onPath = [&](std::uint32_t owner, const PathResults<C>& found, std::uint32_t slot) {
    sums.add(owner, found.radiance.at(slot).luminance());
  };
  const Tracing tracing{view.now.scene, bounces, {}};
  PathRun<S, C, false, decltype(onPath)> run(tracing, onPath);
  const auto forEachPath = [&](const auto& f) {
    forEachSample(seeds, 1, [&](const PixelSequence& numbers, std::uint32_t i) {
      f([&](int x, int y) { return NewPath{numbers.of(x, y, i), sums.owner(x, y, 1)}; });
    });
  };
  addPaths<S>(view, tile, out.g, run, forEachPath, [](int, int, Rgb) {});
  forEachBefore<S>(view, tile, out.g, [&](int x, int y, const PrimaryHit& hit) {
    const float A = luminance(hit.guide.albedo);
    if (!hit.valid || A < kLeastAlbedo) return;  // black
    const std::uint32_t owner = sums.owner(x, y, 0);
    scale[owner] = std::max(out.g.albedo.at(x, y), kLeastAlbedo) / A;
    const PixelPlace of = pixelBefore(out.g, x, y);
    forEachSample(seeds, 0, [&](const PixelSequence& numbers, std::uint32_t i) {
      run.add(hit.start, {numbers.of(of.x, of.y, i), owner});
    });
  });
  run.finish();
  forEachPixel(tile, [&](int x, int y) {
    const float E = out.g.emission.at(x, y);
    out.samples.I1.at(x, y) = E + sums.mean(x, y, 0) * scale[sums.owner(x, y, 0)];
    out.samples.I2.at(x, y) = E + sums.mean(x, y, 1);
  });
}

}  // namespace saccade
