// The view around the start of a path: a measure of the scene, and a bound of the path.
#pragma once

#include <vector>

#include "scene/camera/free_space.h"

namespace saccade {

struct Surroundings {
  // A length that suits the scene: the median distance of what is seen, all directions counted alike; 0 where
  // nothing is seen.
  double sight = 0;
  // Points just before what is seen, where less than kOpen of all directions meet a surface. There a path
  // stays where it still sees some of them, so not behind the scene.
  std::vector<Vec3d> landmarks;
};
inline constexpr double kOpen = 0.6;

Surroundings lookAround(const FreeSpace& space, Vec3d start);

// Whether a quarter of the landmarks is seen from here, or there are none.
bool seesLandmarks(const FreeSpace& space, const Surroundings& around, Vec3d point);

// Uniform on the sphere, from two numbers in [0, 1).
Vec3d directionOf(double u, double v);

}  // namespace saccade
