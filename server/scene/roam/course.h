// A closed way of a camera, without times.
#pragma once

#include <vector>

#include "scene/camera/pose.h"
#include "scene/roam/level.h"

namespace saccade {

// The places and the directions of view are each spread evenly over the course, and smoothed by loopAt().
struct Course {
  std::vector<Vec3d> places, gaze;
  Level level;

  Pose at(double u) const;  // T_world_camera, u from 0 to 1
};

}  // namespace saccade
