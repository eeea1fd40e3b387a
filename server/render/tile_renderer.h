// The function that renders tiles of a scene: compiled for what the scene has.
#pragma once

#include "render/renderer.h"
#include "render/tiles/along_motion.h"
#include "render/tiles/reconnected_tile.h"

namespace saccade {

// Gives features their plane of bodies, where the scene has any.
inline void showBodies(const PixelContext& view, GBuffer& g) {
  if (view.now.scene.bodies() && !g.hasBodies()) g.body = Image<std::uint32_t>(g.z.width(), g.z.height());
}

using TileRenderer = void (*)(const PixelContext& view, const SeedPlan& seeds, int bounces, Tile tile,
                              Frame& out);

// `along_motion`: whether surfaces that move keep their numbers. `reconnects`: see SeedPlan.
inline TileRenderer tileRenderer(const RenderScene& scene, const RenderSettings& settings, bool along_motion,
                                 bool reconnects) {
  if (reconnects && !settings.jitter && settings.bounces > 0)
    return settings.channels == 1 ? renderReconnectedTile<1> : renderReconnectedTile<3>;
  return withKernel(scene.shading(), [&]<Shading S>() -> TileRenderer {
    const bool grey = settings.channels == 1;
    if (settings.jitter) return grey ? renderJitteredTile<S, 1> : renderJitteredTile<S, 3>;
    if (along_motion) return grey ? renderTileAlongMotion<S, 1> : renderTileAlongMotion<S, 3>;
    return grey ? renderTile<S, 1> : renderTile<S, 3>;
  });
}

}  // namespace saccade
