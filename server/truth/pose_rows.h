// Poses and velocities as rows of numbers.
#pragma once

#include <vector>

#include "scene/camera/trajectory.h"

namespace saccade {

inline std::vector<double> poseRow(const Pose& pose) {
  const auto& [p, q] = pose;
  return {p.x, p.y, p.z, q.x, q.y, q.z, q.w};
}

inline std::vector<double> velocityRow(const Velocity& velocity) {
  const auto& [v, w] = velocity;
  return {v.x, v.y, v.z, w.x, w.y, w.z};
}

}  // namespace saccade
