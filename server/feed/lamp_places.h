// Where the strongest lamps of a scene are: the shadows that count are theirs.
#pragma once

#include <cstddef>
#include <vector>

#include "feed/body_point.h"
#include "scene/scene.h"

namespace saccade {

struct LampPlace {
  BodyPoint middle;
  float radius;     // around all of the lamp, scene units
  float power = 0;  // all directions together; Rec. 709
};

// By falling power. A sun lies far away on its side of the scene.
std::vector<LampPlace> strongestLamps(const Scene& scene, std::size_t most);

}  // namespace saccade
