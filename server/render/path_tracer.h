// Estimates the light that leaves a surface point towards the camera: path tracing with next-event estimation
// and multiple importance sampling.
#pragma once

#include "render/color.h"
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

// What traceReflected() tells besides its estimate: nothing, or the direct light at the first vertex that has
// a closed form but for shadows (analytic_light.h).
struct NoParts {
  static constexpr bool kKept = false;
};
template <int Channels>
struct DirectParts {
  static constexpr bool kKept = true;
  Color<Channels> unoccluded, visible;  // what a white diffuse surface would reflect of a sample
  Color<Channels> weighed;              // what of the path's own estimate is such light
};

// One estimate of the radiance that leaves `start` after at most `bounces` indirect bounces off rough
// surfaces. 0 bounces are direct light only.
// The estimate leaves out the light that `start` and the surfaces along its view emit (guide.h). That light
// is known without noise.
template <Shading S, int Channels, class Parts>
Color<Channels> traceReflected(const RenderScene& scene, const EmitterStrengths& strengths,
                               const PathStart& start, const PathSampler& sampler, int bounces, Parts& parts);

}  // namespace saccade
