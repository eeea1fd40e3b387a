// The primary hit of a pixel and the features the filter guides itself by.
#pragma once

#include "frame/frame.h"
#include "render/camera.h"
#include "render/path_tracer.h"

namespace saccade {

struct PrimaryHit {
  PathStart start;
  Rgb emission;        // that is seen without noise: of the guide, or of the environment where nothing is hit
  bool valid = false;  // whether anything is hit
};

// Traces the centre of pixel (x, y) and fills that pixel of `g`. With centre sampling both passes of a frame
// share this hit. `prev` is the camera of the previous frame.
template <Shading S>
PrimaryHit tracePrimary(const RenderScene& scene, const EmitterStrengths& strengths, const Camera& camera,
                        const Camera& prev, int x, int y, GBuffer& g);

}  // namespace saccade
