// The primary hit of a pixel and the features the filter guides itself by.
#pragma once

#include "frame/frame.h"
#include "render/camera.h"
#include "render/guide.h"

namespace saccade {

struct PrimaryHit {
  Vec3 direction;      // of the ray, 1 along the viewing axis
  PathStart start;     // means nothing where nothing is hit
  Guide guide;         // its emission is seen without noise: of the environment where nothing is hit
  bool valid = false;  // whether anything is hit
};

// Through the point (x, y) in pixels; whole numbers are pixel centres.
template <Shading S>
PrimaryHit tracePrimary(const RenderScene& scene, const EmitterStrengths& strengths, const Camera& camera,
                        float x, float y);

// Fills pixel (x, y) of `g` with what its centre hits. `prev` is the camera of the previous frame.
void writeFeatures(const PrimaryHit& primary, const Camera& camera, const Camera& prev, int x, int y,
                   GBuffer& g);

}  // namespace saccade
