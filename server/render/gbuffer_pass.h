// The primary hit of a pixel and the features the filter guides itself by.
#pragma once

#include "frame/frame.h"
#include "render/camera.h"
#include "render/render_scene.h"
#include "scene/emitter_strengths.h"

namespace saccade {

struct PrimaryHit {
  Surface surface;
  Rgb emission;  // surface.radiance at its strength
  bool valid = false;
};

// Traces the centre of pixel (x, y) and fills that pixel of `g`. With centre sampling both passes of a frame
// share this hit. `prev` is the camera of the previous frame.
PrimaryHit tracePrimary(const RenderScene& scene, const EmitterStrengths& strengths, const Camera& camera,
                        const Camera& prev, int x, int y, GBuffer& g);

}  // namespace saccade
