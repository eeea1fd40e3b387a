// Paths in closed form: a sum of sines along each axis, so that all derivatives are continuous.
#pragma once

#include <array>
#include <vector>

#include "base/units.h"
#include "scene/camera/pose.h"

namespace saccade {

// offset + the sum of amplitude * sin(2 pi cycles u + phase), of the share u of a period that has passed.
struct SineSum {
  struct Sine {
    double amplitude;
    int cycles;  // in a period
    double phase;
  };
  std::vector<Sine> sines;
  double offset = 0;

  double at(double u) const;
  double slopeAt(double u) const;  // the derivative by u
};

// Repeats for ever.
struct SinePath {
  Pose home;      // T_world_camera where all sums are 0
  TimeNs period;  // > 0
  // In the axes of `home`: right, down and forward in scene units. Then turns to the right, up and clockwise
  // in radians, each in the axes that the turn before leaves.
  std::array<SineSum, 6> axes;

  Pose at(TimeNs t) const;
  Velocity velocityAt(TimeNs t) const;
};

}  // namespace saccade
