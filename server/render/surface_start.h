// Where the paths of a pixel start, for SurfaceSamples.
#pragma once

#include "render/path_start.h"

namespace saccade {

// What of a surface is seen directly and reflects alike into all directions.
struct DiffuseBase {
  Rgb albedo;        // 0: there is none
  bool all = false;  // the surface is nothing else
};

struct SurfaceStart {
  PathStart path;
  DiffuseBase base;
  float albedo = 0;  // luminance
};

}  // namespace saccade
