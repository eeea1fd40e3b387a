// The lamps of a scene at one time, where some of them are bodies.
#pragma once

#include <span>

#include "render/lights/analytic_light.h"
#include "render/lights/delta_lamps.h"
#include "render/lights/light_columns.h"
#include "render/lights/lights.h"
#include "scene/motion/rigid_motion.h"

namespace saccade {

struct PosedLamps {
  PosedLamps(const Scene& scene, const Lights& still);

  // Takes a time in proportion to the number of lamps.
  void place(const Scene& scene, std::span<const RigidMotion> motions);

  std::vector<char> bodies;  // by body, whether it gives light
  Scene shapes;              // those that emit; others are empty, so that ids stay, and lamps without extent
  Lights lights;
  DeltaLamps deltas;
  AnalyticLight analytic;
  LightColumns columns;
};

}  // namespace saccade
