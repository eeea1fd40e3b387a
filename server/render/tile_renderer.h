// The function that renders tiles of a scene: compiled for what the scene has.
#pragma once

#include "render/renderer.h"
#include "render/tiles/tile_samples.h"

namespace saccade {

// Gives features their plane of bodies, where the scene has any.
inline void showBodies(const PixelContext& view, GBuffer& g) {
  if (view.now.scene.bodies() && !g.hasBodies()) g.body = Image<std::uint32_t>(g.z.width(), g.z.height());
}

using TileRenderer = void (*)(const PixelContext& view, const SeedPlan& seeds, int bounces, Tile tile,
                              Frame& out);

inline TileRenderer tileRenderer(const RenderScene& scene, const RenderSettings& settings) {
  return withKernel(scene.shading(), [&]<Shading S>() -> TileRenderer {
    if (settings.jitter) return settings.channels == 1 ? renderJitteredTile<S, 1> : renderJitteredTile<S, 3>;
    return settings.channels == 1 ? renderTile<S, 1> : renderTile<S, 3>;
  });
}

}  // namespace saccade
