// Rules for every path that was accepted.
#pragma once

#include <cmath>

#include "base/check.h"
#include "scene/camera/trajectory.h"

namespace saccade {

// Ends the program unless the pose is a real one at `t`, and around every key of the path's beginning and
// end.
inline void checkPath(const Trajectory& path, TimeNs t) {
  const TimeNs last = path.lastTime(), one{1};
  for (const TimeNs when : {t, TimeNs{0}, one, last / 2, last - one, last, last + one}) {
    const Pose pose = path.at(when);
    const Quaternion& q = pose.rotation;
    SACCADE_CHECK(std::isfinite(pose.position.x + pose.position.y + pose.position.z));
    SACCADE_CHECK(std::abs(std::hypot(std::hypot(q.x, q.y), std::hypot(q.z, q.w)) - 1) < 1e-6);
  }
}

}  // namespace saccade
