// The pixels of a tile and their primary hits, block by block, so that neighbours' rays are traced together.
#pragma once

#include <algorithm>
#include <array>

#include "render/primary/gbuffer_pass.h"
#include "render/primary/primary_block.h"

namespace saccade {

template <class F>
void forEachPixel(Tile tile, const F& f) {
  for (int y = tile.y0; y < tile.y1; ++y)
    for (int x = tile.x0; x < tile.x1; ++x) f(x, y);
}

// Traces the rays through the centres of a tile's pixels, and writes their features to `g`. Each block is
// made in block_at(x, y), of its first pixel. Calls on_plain(PrimaryBlock) for each block that shows plain
// surfaces, and on_other(x, y, hit) for each other pixel.
template <Shading S, class BlockAt, class OnPlain, class OnOther>
void forEachPrimary(const PixelContext& view, Tile tile, GBuffer& g, const BlockAt& block_at,
                    const OnPlain& on_plain, const OnOther& on_other) {
  PrimaryHit hit;
  for (int y0 = tile.y0; y0 < tile.y1; y0 += kBlockEdge) {
    for (int x0 = tile.x0; x0 < tile.x1; x0 += kBlockEdge) {
      const Tile pixels{x0, y0, std::min(x0 + kBlockEdge, tile.x1), std::min(y0 + kBlockEdge, tile.y1)};
      PrimaryBlock& block = block_at(x0, y0);
      tracePrimaryBlock(view, pixels, g, block);
      if (block.plain.any()) on_plain(block);
      forEachLane(block.others, [&](int i) {
        shadePrimary<S>(view, block.rays[static_cast<std::size_t>(i)],
                        block.hits[static_cast<std::size_t>(i)], hit);
        writeFeatures(hit, view.now.camera, view.before.camera, block.x(i), block.y(i), g);
        on_other(block.x(i), block.y(i), hit);
      });
    }
  }
}

// Points of one pixel, by their offsets from its centre.
template <std::size_t kCount>
std::array<Vec2, kCount> subPixelPoints(int x, int y, const std::array<Vec2, kCount>& offsets) {
  std::array<Vec2, kCount> points;
  for (std::size_t i = 0; i < kCount; ++i)
    points[i] = {static_cast<float>(x) + offsets[i].x, static_cast<float>(y) + offsets[i].y};
  return points;
}

}  // namespace saccade
