// What stands around a surface point, for methods that keep light on surfaces.
#pragma once

#include <array>
#include <limits>

#include "base/vec.h"

namespace saccade {

struct Obstacle {
  float distance = std::numeric_limits<float>::infinity();  // scene units; infinite where nothing is met
  Vec3 normal;                                              // of unit length, of either side
};

class Obstacles {
 public:
  static constexpr int kWays = 8;  // looked along at once
  struct Way {
    Vec3 from, along;  // `along` has unit length
    float reach = 0;   // scene units
  };
  using Ways = std::array<Way, kWays>;
  using Met = std::array<Obstacle, kWays>;

  virtual ~Obstacles() = default;
  // The nearest surface on each way that lets no light straight through.
  virtual Met find(const Ways& ways) const = 0;
};

}  // namespace saccade
