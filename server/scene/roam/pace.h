// How fast a camera goes along a course, so that its image moves evenly.
#pragma once

#include <vector>

#include "scene/camera/free_space.h"
#include "scene/camera/lens.h"
#include "scene/roam/course.h"
#include "scene/roam/panorama.h"

namespace saccade {

// Of a course, at kLooks places that are spread evenly over it.
struct Pace {
  static constexpr std::size_t kLooks = 128;
  std::vector<double> seen;       // the share of the picture, by place
  std::vector<double> durations;  // of the part from each place to the next, in seconds at image speed 1
};

// The durations make the median speed of the images 1 focal length per second over the whole course. The
// medians of its places are near that, but change slowly. Where images move little, the camera goes faster,
// within bounds of its velocity. It turns by at most kMostTurn radians per second at that speed.
inline constexpr double kMostTurn = 2;
Pace measurePace(const FreeSpace& space, const Course& course, const Lens& lens, const SeenRange& range);

// So many poses of the course, evenly in time.
std::vector<Pose> evenlyInTime(const Course& course, const Pace& pace, std::size_t poses);

}  // namespace saccade
