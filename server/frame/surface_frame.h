// A frame between its two steps: features and surfaces are known, and paths are not traced yet.
#pragma once

#include <chrono>

#include "frame/frame.h"
#include "frame/obstacles.h"

namespace saccade {

struct SurfaceFrame {
  Frame& frame;                   // with SurfaceSamples
  const Obstacles& obstacles;     // of the scene
  std::chrono::nanoseconds time;  // CPU time that the surfaces took
};

}  // namespace saccade
