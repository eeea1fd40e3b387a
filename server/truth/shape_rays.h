// Which shapes the rays through pixel centres meet first. They are the rays of the renderer.
#pragma once

#include <span>

#include "render/camera/camera.h"
#include "render/world/posed_scene.h"

namespace saccade {

inline constexpr std::size_t kShapeRays = 16;  // at once

struct ShapeRay {
  float x, y;  // the pixel
};

// At most kShapeRays of them.
void meetShapes(const PosedScene& scene, const Camera& camera, std::span<const ShapeRay> rays,
                std::span<Hit> hits);

}  // namespace saccade
