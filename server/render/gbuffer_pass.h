// The primary hit of a pixel, and the features of that pixel that guide the filter.
#pragma once

#include "frame/frame.h"
#include "render/camera.h"
#include "render/guide.h"

namespace saccade {

struct PrimaryHit {
  Vec3 direction;      // of the ray, 1 along the viewing axis
  PathStart start;     // valid where a surface is hit
  Guide guide;         // its emission has no noise; where nothing is hit, that of the environment
  bool valid = false;  // whether a surface is hit
};

// Traces the ray through the point (x, y) in pixels. Pixel centres are whole numbers.
template <Shading S>
PrimaryHit tracePrimary(const RenderScene& scene, const EmitterStrengths& strengths, const Camera& camera,
                        float x, float y);

// Writes the features of a hit to pixel (x, y) of `g`. `prev` is the camera of the previous frame.
void writeFeatures(const PrimaryHit& primary, const Camera& camera, const Camera& prev, int x, int y,
                   GBuffer& g);

}  // namespace saccade
