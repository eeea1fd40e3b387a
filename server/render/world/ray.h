// A ray, and what it hits.
#pragma once

#include <cstdint>

#include "base/vec.h"

namespace saccade {

struct Ray {
  Vec3 origin;
  Vec3 direction;  // any length; t counts in units of it
  float tfar;
};

struct Hit {
  float t;
  Vec3 normal;  // geometric, as wound, not normalised
  float u, v;   // barycentric, of vertices 1 and 2
  std::uint32_t geometry, primitive;
  bool valid = false;
};

}  // namespace saccade
