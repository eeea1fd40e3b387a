#include "render/lights/delta_lamps.h"

#include "render/lights/delta_samples.h"

namespace saccade {

DeltaLamps::DeltaLamps(const Scene& scene, const Lamps& lamps)
    : spots_(spotsOf(scene)), suns_(scene.directional_lights) {
  if (areFew() || !lamps.hasTree(LightSet::kAll)) return;
  const LampTree& tree = lamps.tree(LightSet::kAll);  // of areas, then spots
  for (std::size_t i = tree.count() - spots_.size(); i < tree.count(); ++i)
    groups_.push_back(static_cast<std::uint8_t>(tree.groupOf(static_cast<std::uint32_t>(i))));
}

IncidentLight DeltaLamps::at(std::size_t lamp, Vec3 point) const {
  if (lamp < spots_.size()) return sampleOf(spots_[lamp], point, 1);
  return sampleOf(suns_[lamp - spots_.size()], 1);
}

}  // namespace saccade
