#include "scene/emitter_strengths.h"

#include <algorithm>
#include <bit>

#include "base/hash_rng.h"

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

std::uint64_t EmitterStrengths::state() const {
  std::uint64_t hash = 0;
  for (const float factor : factors_) hash = hashKey(hash, std::bit_cast<std::uint32_t>(factor));
  return hash;
}

}  // namespace saccade
