// A frame's view, as the passes over its pixels read it.
#pragma once

#include "render/camera/camera.h"
#include "render/world/posed_scene.h"

namespace saccade {

// A camera, and the scene at the time of its picture.
struct PosedView {
  const PosedScene& scene;
  const Camera& camera;
};

struct PixelContext {
  PixelContext(const PosedView& now, const PosedView& before) : now(now), before(before) {}
  // Of a picture without a frame before it.
  explicit PixelContext(const PosedView& now) : PixelContext(now, now) {}

  // Where a point of a surface was in the frame before. `body`: Hit::body.
  Vec3 pointBefore(std::uint32_t body, Vec3 point) const {
    return now.scene.carried(body, point, before.scene);
  }

  PosedView now, before;  // of the frame, and of the one before it
};

}  // namespace saccade
