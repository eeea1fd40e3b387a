// A camera that is level: its rows are horizontal.
#pragma once

#include "scene/camera/pose.h"

namespace saccade {

// World axes, of unit length.
struct Level {
  Vec3d ahead, right, up;

  // Turned to the right by `pan` radians, then up by `tilt`.
  Vec3d direction(double pan, double tilt) const;
  // Of a level camera that looks this way, neither up nor down; of any length.
  Quaternion rotation(Vec3d direction) const;
};

// Up is the axis of the world that is nearest to the upper side of this camera, which looks about ahead.
Level levelOf(const Quaternion& camera);

}  // namespace saccade
