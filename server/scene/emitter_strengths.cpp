#include "scene/emitter_strengths.h"

#include <algorithm>
#include <utility>

namespace saccade {

EmitterStrengths::EmitterStrengths(const Scene& scene) {
  for (const Mesh& mesh : scene.meshes) strengths_.push_back(&mesh.strength);
  for (const Sphere& sphere : scene.spheres) strengths_.push_back(&sphere.strength);
  if (std::all_of(strengths_.begin(), strengths_.end(), [](const Strength* s) { return s->isSteady(); }))
    strengths_.clear();
  factors_.resize(strengths_.size());
  setTime(TimeNs{0});
}

bool EmitterStrengths::setTime(TimeNs t) {
  bool changed = false;
  for (std::size_t i = 0; i < strengths_.size(); ++i) {
    const float before = std::exchange(factors_[i], strengths_[i]->at(t));
    changed = changed || factors_[i] != before;
  }
  return changed;
}

}  // namespace saccade
