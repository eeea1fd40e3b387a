// Compiles the path tracer for one set of features (shading.h). Each large set has its own .cpp file. Another
// set in that file would change what the compiler inlines, and so the speed and the rounding.
#pragma once

#include "render/guide_kernel.h"
#include "render/path_tracer_kernel.h"

#define SACCADE_COMPILE_KERNEL(S)                                                                       \
  template Color<1> traceReflected<S, 1>(const RenderScene&, const EmitterStrengths&, const PathStart&, \
                                         const PathSampler&, int);                                      \
  template Color<3> traceReflected<S, 3>(const RenderScene&, const EmitterStrengths&, const PathStart&, \
                                         const PathSampler&, int);                                      \
  template Guide findGuide<S>(const RenderScene&, const EmitterStrengths&, const Ray&, const Hit&,      \
                              const PathStart&);
