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

  // Where a point of a shape was in the frame before.
  Vec3 pointBefore(const ShapePoint& on, Vec3 point) const {
    return now.scene.carried(on, point, before.scene);
  }

  PosedView now, before;  // of the frame, and of the one before it
};

}  // namespace saccade
