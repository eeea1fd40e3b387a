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

// A point of a shape, wherever its body lies and whatever form its mesh has.
struct ShapePoint {
  // One that moves as a body does.
  static ShapePoint ofBody(std::uint32_t body) { return {body, ~0u, 0, 0, 0}; }

  std::uint32_t body = kNoBody;  // of Scene::bodies
  std::uint32_t geometry, primitive;
  float u, v;  // barycentric, of vertices 1 and 2
};

struct Hit : ShapePoint {
  float t;
  Vec3 normal;  // geometric, as wound, not normalised; of a body in the place of the scene file
  bool valid = false;
};

}  // namespace saccade
