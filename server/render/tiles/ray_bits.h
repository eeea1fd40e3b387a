// How the first shadow rays of a point to one group of lamps ended: bit r stands for ray r.
#pragma once

#include <cstdint>

namespace saccade {

struct RayBits {
  static std::uint32_t of(int ray) { return ray < 32 ? 1u << ray : 0; }

  std::uint32_t lit = 0, dark = 0;  // nothing stood in the way; no light came through
};

}  // namespace saccade
