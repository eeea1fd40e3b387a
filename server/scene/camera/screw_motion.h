// Motion at a constant velocity of the camera, straight or about an axis.
#pragma once

#include <optional>

#include "scene/camera/image_speed.h"
#include "scene/camera/trajectory.h"

namespace saccade {

struct Screw {
  Twist velocity;      // at rate 1, in the camera's axes at the start: scene units or radians per second,
  Vec3d pivot;         // angular about this point
  double usual_reach;  // how far it goes where no time to turn back is given: scene units or radians

  bool rotates() const { return velocity.angular != Vec3d{}; }
  Twist twist() const { return {velocity.linear - cross(velocity.angular, pivot), velocity.angular}; }
  // Relative to the start, when it has gone so many scene units or radians.
  Pose after(double distance) const;
};

// `rate` in scene units or radians per second, not 0. Turns back after `turn_s` seconds, and again at the
// start, and so on. The limits are those of motion.h.
Trajectory thereAndBack(const Screw& screw, const Pose& start, double rate, std::optional<double> turn_s);

// The motion that never turns back. It goes round and round, or straight on for 1e9 seconds.
Trajectory onAndOn(const Screw& screw, const Pose& start, double rate);

}  // namespace saccade
