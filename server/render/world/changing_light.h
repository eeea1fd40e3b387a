// Where the direct light of lamps in closed form may have changed between two times of a scene [ours].
#pragma once

#include <vector>

#include "render/world/moved_bodies.h"

namespace saccade {

class ChangingLight {
 public:
  // `moved`: between both times; it outlives this. Where nothing has moved, light changes nowhere.
  ChangingLight(const PosedScene& now, const PosedScene& before, const MovedBodies& moved);

  // Whether a body may stand, or have stood, or moved between a point and a lamp.
  bool at(Vec3 point) const;

 private:
  const MovedBodies& moved_;
  std::vector<ShapeBox> lamps_;  // around the groups of AnalyticLight, at both times
};

}  // namespace saccade
