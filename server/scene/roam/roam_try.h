// One try to draw a path.
#pragma once

#include <cstdint>
#include <optional>

#include "scene/camera/lens.h"
#include "scene/camera/spline_path.h"
#include "scene/roam/level.h"
#include "scene/roam/panorama.h"
#include "scene/roam/surroundings.h"

namespace saccade {

// All tries of a path share this.
struct RoamPlace {
  RoamPlace(const Pose& start, const FreeSpace& space, const Lens& lens);

  const FreeSpace& space;
  const Lens& lens;
  Pose start;
  Level level;
  Surroundings around;  // of the start
  SeenRange range;      // by their sight
  double enough;        // half of the most that a picture from the start could show, by its share
};

// Its times are those of image speed 1, a focal length per second.
struct RoamPath {
  std::vector<Pose> poses;  // controls of a SplinePath
  double period_s;
  double seen;  // the least share of a picture that is seen
};

// None where the seed draws no path that keeps the clearance all along. Fewer stops make a shorter path.
std::optional<RoamPath> tryRoam(const RoamPlace& place, double clearance, std::size_t stops,
                                std::uint64_t seed);

}  // namespace saccade
