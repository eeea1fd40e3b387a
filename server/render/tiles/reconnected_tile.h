// The samples of a tile for SeedPlan::reconnected.
#pragma once

#include "render/tiles/tile_samples.h"

namespace saccade {

// Both passes trace the paths that SeedPlan::correlated would. Pass 1 then shifts light i that comes over two
// diffuse surfaces. Let x2 be the second vertices of the frame before, and y2 those of pass 2:
//     i1_t = mean s(x2) L(x2) + mean (s(y2) - 1) L(y2),   s = 2 G_t / (G_t + G_{t-1})
// G is the geometry term of a second vertex with the first vertex of either frame, and L is the light that it
// reflects. The mean is that of frame t, by multiple importance sampling of both frames' paths. Where s = 1,
// pass 1 repeats pass 2 of the frame before.
// All other light is replayed, and all light of pixels that do not show diffuse surfaces in both frames.
// Frames of cameras that stand are replayed, and frames since which lamps or bodies have changed.
template <int C>
void renderReconnectedTile(const PixelContext& view, const SeedPlan& seeds, int bounces, Tile tile,
                           Frame& out);

}  // namespace saccade
