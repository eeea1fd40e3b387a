#include "render/lights/delta_lamps.h"

#include "render/lights/delta_samples.h"

namespace saccade {

DeltaLamps::DeltaLamps(const Scene& scene) : spots_(spotsOf(scene)), suns_(scene.directional_lights) {}

IncidentLight DeltaLamps::at(std::size_t lamp, Vec3 point) const {
  if (lamp < spots_.size()) return sampleOf(spots_[lamp], point, 1);
  return sampleOf(suns_[lamp - spots_.size()], 1);
}

}  // namespace saccade
