// Estimates the light that leaves a surface point towards the camera: path tracing with next-event estimation
// and multiple importance sampling.
#pragma once

#include "render/path_parts.h"
#include "render/path_sampler.h"
#include "render/render_scene.h"
#include "scene/emitter_strengths.h"

namespace saccade {

// The first surface that a pixel's ray meets.
struct PathStart {
  Surface surface;
  Vec3 direction;  // in which the ray arrived, unit
  RayCone cone;    // at the surface
};

// The most mirrors, panes and masks between a pixel and the surface that guides the filter.
inline constexpr int kMaxViewDepth = 8;

// One estimate of the radiance that leaves `start` after at most `bounces` indirect bounces off rough
// surfaces. 0 bounces are direct light only.
// The estimate leaves out the light that `start` and the surfaces along its view emit (guide.h). That light
// is known without noise.
template <Shading S, int Channels, class Parts>
Color<Channels> traceReflected(const RenderScene& scene, const EmitterStrengths& strengths,
                               const PathStart& start, const PathSampler& sampler, int bounces, Parts& parts);

}  // namespace saccade
