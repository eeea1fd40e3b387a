// The strengths of all emitters of a scene at one time.
#pragma once

#include <cstddef>
#include <vector>

#include "scene/scene.h"

namespace saccade {

// A table of factors on radiance by geometry id: meshes in the order of Scene::meshes, then spheres. It is
// empty, and costs nothing, where every emitter is steady.
class EmitterStrengths {
 public:
  explicit EmitterStrengths(const Scene& scene);  // at time 0; keeps pointers into `scene`

  // Stream time, at least 0. Returns whether any strength differs from before. Allocates nothing.
  bool setTime(TimeNs t);
  float operator[](std::size_t geometry) const { return factors_.empty() ? 1.f : factors_[geometry]; }
  const std::vector<float>& factors() const { return factors_; }

 private:
  std::vector<const Strength*> strengths_;
  std::vector<float> factors_;
};

}  // namespace saccade
