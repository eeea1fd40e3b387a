// How far the picture moves from one time to another in a scene with bodies.
#pragma once

#include <vector>

#include "render/camera/camera.h"
#include "render/world/posed_scene.h"

namespace saccade {

class MovingView {
 public:
  struct At {
    const Camera& camera;
    TimeNs time;
  };

  // `scene` outlives this. `paths`: of its bodies, in their order.
  MovingView(const RenderScene& scene, const std::vector<Trajectory>& paths);

  // Samples the pixels of `now` on a grid. Appends how far each surface has moved in the picture, in the unit
  // of the plane at distance 1. Those that were behind the camera are left out.
  void appendSteps(const At& now, const At& before, const CameraModel& camera, std::vector<double>& lengths);

 private:
  PosedScene now_, before_;
};

}  // namespace saccade
