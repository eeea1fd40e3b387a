// Obstacles around a surface point, for methods that keep light on surfaces.
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
  static constexpr int kRays = 8;  // traced at once
  struct ProbeRay {
    Vec3 from, along;  // `along` has unit length
    float reach = 0;   // scene units
  };
  using ProbeRays = std::array<ProbeRay, kRays>;
  using Hits = std::array<Obstacle, kRays>;

  virtual ~Obstacles() = default;
  // The nearest surface on each ray that lets no light straight through.
  virtual Hits find(const ProbeRays& rays) const = 0;
};

}  // namespace saccade
