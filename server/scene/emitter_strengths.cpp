#include "scene/emitter_strengths.h"

#include <algorithm>

namespace saccade {

EmitterStrengths::EmitterStrengths(const Scene& scene) {
  for (const Mesh& mesh : scene.meshes) strengths_.push_back(&mesh.strength);
  for (const Sphere& sphere : scene.spheres) strengths_.push_back(&sphere.strength);
  if (std::all_of(strengths_.begin(), strengths_.end(), [](const Strength* s) { return s->isSteady(); }))
    strengths_.clear();
  factors_.resize(strengths_.size());
  setTime(TimeNs{0});
}

void EmitterStrengths::setTime(TimeNs t) {
  for (std::size_t i = 0; i < strengths_.size(); ++i) factors_[i] = strengths_[i]->at(t);
}

}  // namespace saccade
