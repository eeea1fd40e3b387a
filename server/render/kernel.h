// Compiles the path tracer for one set of features (shading.h). Each large set has its own .cpp file. Another
// set in that file would change what the compiler inlines, and so the speed and the rounding.
#pragma once

#include "render/guide_kernel.h"
#include "render/path_tracer_kernel.h"

#define SACCADE_COMPILE_PATHS(S, CHANNELS, PARTS)              \
  template Color<CHANNELS> traceReflected<S, CHANNELS, PARTS>( \
      const RenderScene&, const EmitterStrengths&, const PathStart&, const PathSampler&, int, PARTS&);

#define SACCADE_COMPILE_KERNEL(S)                                                                  \
  SACCADE_COMPILE_PATHS(S, 1, NoParts)                                                             \
  SACCADE_COMPILE_PATHS(S, 3, NoParts)                                                             \
  template Guide findGuide<S>(const RenderScene&, const EmitterStrengths&, const Ray&, const Hit&, \
                              const PathStart&);

// The same paths for SurfaceSamples.
#define SACCADE_COMPILE_PARTS(S)            \
  SACCADE_COMPILE_PATHS(S, 1, PathParts<1>) \
  SACCADE_COMPILE_PATHS(S, 3, PathParts<3>)
