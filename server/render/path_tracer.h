// Light that reaches a surface point and leaves it towards the camera: path tracing with next-event
// estimation and multiple importance sampling.
#pragma once

#include "render/color.h"
#include "render/path_sampler.h"
#include "render/render_scene.h"
#include "scene/emitter_strengths.h"

namespace saccade {

// One estimate of the radiance reflected at `primary` after at most `bounces` indirect bounces (0: direct
// light only). Emission of `primary` itself is not in it.
template <int Channels>
Color<Channels> traceReflected(const RenderScene& scene, const EmitterStrengths& strengths,
                               const Surface& primary, const PathSampler& sampler, int bounces);

}  // namespace saccade
