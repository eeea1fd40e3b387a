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

inline constexpr std::uint32_t kNoBody = ~0u;  // a shape that stands

struct Hit {
  float t;
  // Geometric, as wound, not normalised; of a body as the scene file has it.
  Vec3 normal;
  float u, v;  // barycentric, of vertices 1 and 2
  std::uint32_t geometry, primitive;
  std::uint32_t body = kNoBody;  // of Scene::bodies
  bool valid = false;
};

}  // namespace saccade
