// The strengths of all emitters of a scene at one time.
#pragma once

#include <cstddef>
#include <vector>

#include "scene/scene.h"

namespace saccade {

// A table of factors on radiance by geometry id: meshes in the order of Scene::meshes, then spheres. It is
// empty, and costs nothing, where every emitter is steady at all times.
class EmitterStrengths {
 public:
  explicit EmitterStrengths(const Scene& scene);  // at time 0; keeps pointers into `scene`

  void setTime(TimeNs t);  // stream time, at least 0; allocates nothing
  // A number for all of them together: a hash, so that equal strengths have equal numbers.
  std::uint64_t state() const;
  float operator[](std::size_t geometry) const { return areSteady() ? 1.f : factors_[geometry]; }
  const std::vector<float>& factors() const { return factors_; }
  bool areSteady() const { return factors_.empty(); }

 private:
  std::vector<const Strength*> strengths_;
  std::vector<float> factors_;
};

}  // namespace saccade
