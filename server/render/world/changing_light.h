// Where the direct light of lamps in closed form may have changed between two times of a scene [ours].
#pragma once

#include <vector>

#include "render/world/posed_scene.h"
#include "scene/motion/shape_box.h"

namespace saccade {

class ChangingLight {
 public:
  // At a scene without bodies it changes nowhere.
  ChangingLight(const PosedScene& now, const PosedScene& before);

  // Whether a body may stand, or have stood, or moved between a point and a lamp.
  bool at(Vec3 point) const;
  bool isMoving(std::uint32_t body) const { return moves_[body]; }

 private:
  std::vector<char> moves_;       // by body
  std::vector<ShapeBox> bodies_;  // around those that move, at both times
  std::vector<ShapeBox> lamps_;   // around the groups of AnalyticLight, at both times
};

}  // namespace saccade
