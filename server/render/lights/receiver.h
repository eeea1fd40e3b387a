// The receiver of light.
#pragma once

#include "base/vec.h"

namespace saccade {

// A point of a surface.
struct Receiver {
  Vec3 point;
  Vec3 normal;  // geometric, unit; light comes from its side alone
};

}  // namespace saccade
