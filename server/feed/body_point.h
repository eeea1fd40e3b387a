// A point that moves with a body, or stands.
#pragma once

#include <cstdint>
#include <span>

#include "scene/motion/rigid_motion.h"

namespace saccade {

struct BodyPoint {
  std::uint32_t body = 0;  // 1 + its number; 0: it stands
  Vec3 rest;               // scene axes; of a body as the file has it

  // `now`: in scene axes, where the bodies lie as `motions` say.
  static BodyPoint of(Vec3 now, std::uint32_t body, std::span<const RigidMotion> motions) {
    return {body, body > 0 ? motions[body - 1].restPoint(now) : now};
  }
  Vec3 at(std::span<const RigidMotion> motions) const {
    return body > 0 ? motions[body - 1].point(rest) : rest;
  }
};

}  // namespace saccade
