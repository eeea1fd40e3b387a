// A frame's view, as the passes over its pixels read it.
#pragma once

#include "render/camera/camera.h"
#include "render/world/render_scene.h"
#include "scene/emitter_strengths.h"

namespace saccade {

struct PixelContext {
  const RenderScene& scene;
  const EmitterStrengths& strengths;
  const Camera &camera, &prev;
};

}  // namespace saccade
