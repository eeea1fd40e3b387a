// How far the picture of a feed will move.
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "frame/frame.h"
#include "render/camera/camera.h"
#include "render/world/posed_scene.h"

namespace saccade {

class ViewMotion {
 public:
  // Takes the surfaces that `frame` shows on a grid of pixels, as `camera` and `scene` have made it.
  void look(const Frame& frame, const Camera& camera, const PosedScene& scene);

  // How far they move in the picture from the time of the last call, or of look(), to `t`: the 99th
  // percentile, in pixels. Leaves out what is behind the camera. Bodies lie where the paths of `scene` have
  // them at `t`. 0 where no surface is in view. Allocates nothing after the first look().
  double moveTo(TimeNs t, const Camera& camera, const PosedScene& scene);

 private:
  struct Point {
    std::uint32_t body;  // 1 + its number; 0: it stands
    Vec3 rest;           // scene axes; of a body as the file has it
    Camera::Projection at;
  };
  // Where a point is in the picture of a camera.
  Camera::Projection project(const Point& point, const Camera& camera) const;

  std::vector<Point> points_;
  std::vector<RigidMotion> motions_;  // of the bodies
  std::vector<float> lengths_;
};

}  // namespace saccade
