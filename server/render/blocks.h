// The pixels of a tile and their primary hits, block by block, so that neighbours' rays are traced together.
#pragma once

#include <algorithm>
#include <array>

#include "base/pool_handle.h"
#include "render/gbuffer_pass.h"

namespace saccade {

template <class F>
void forEachPixel(Tile tile, const F& f) {
  for (int y = tile.y0; y < tile.y1; ++y)
    for (int x = tile.x0; x < tile.x1; ++x) f(x, y);
}

// Calls f(block, hits) for blocks of pixels, with the hits at their centres in the order of forEachPixel().
template <Shading S, class F>
void forEachPrimaryBlock(const PixelContext& view, Tile tile, const F& f) {
  constexpr int kEdge = 4;  // so large is a packet of 16
  std::array<Vec2, kMostPoints> points;
  std::array<PrimaryHit, kMostPoints> hits;
  for (int y0 = tile.y0; y0 < tile.y1; y0 += kEdge) {
    for (int x0 = tile.x0; x0 < tile.x1; x0 += kEdge) {
      const Tile block{x0, y0, std::min(x0 + kEdge, tile.x1), std::min(y0 + kEdge, tile.y1)};
      std::size_t count = 0;
      forEachPixel(block, [&](int x, int y) {
        points[count++] = {static_cast<float>(x), static_cast<float>(y)};
      });
      tracePrimaries<S>(view, points, std::span(hits).first(count));
      f(block, std::span<const PrimaryHit>(hits).first(count));
    }
  }
}

// Calls f(x, y, hit) for each pixel, with the hit at its centre.
template <Shading S, class F>
void forEachPrimary(const PixelContext& view, Tile tile, const F& f) {
  forEachPrimaryBlock<S>(view, tile, [&](Tile block, std::span<const PrimaryHit> hits) {
    std::size_t i = 0;
    forEachPixel(block, [&](int x, int y) { f(x, y, hits[i++]); });
  });
}

// The hits at points of one pixel, by their offsets from its centre.
template <Shading S, std::size_t kCount>
std::array<PrimaryHit, kCount> traceSubPixels(const PixelContext& view, int x, int y,
                                              const std::array<Vec2, kCount>& offsets) {
  std::array<Vec2, kCount> points;
  for (std::size_t i = 0; i < kCount; ++i)
    points[i] = {static_cast<float>(x) + offsets[i].x, static_cast<float>(y) + offsets[i].y};
  std::array<PrimaryHit, kCount> hits;
  tracePrimaries<S>(view, points, hits);
  return hits;
}

}  // namespace saccade
