// Compiles what depends on a set of features (shading.h). Each large set has its own .cpp file. Another set
// in that file would change what the compiler inlines, and so the speed and the rounding.
#pragma once

#include "render/paths/surface_stages_kernel.h"
#include "render/primary/guide_kernel.h"

#define SACCADE_COMPILE_KERNEL(S)                                                             \
  template SurfaceStages<1> surfaceStages<S, 1, false>();                                     \
  template SurfaceStages<3> surfaceStages<S, 3, false>();                                     \
  template SurfaceStages<1> surfaceStages<S, 1, true>();                                      \
  template SurfaceStages<3> surfaceStages<S, 3, true>();                                      \
  template Guide findGuide<S>(const PixelContext&, const Ray&, const Hit&, const PathStart&); \
  template Rgb mirrorImage<S>(const PosedScene&, const PathStart&);
