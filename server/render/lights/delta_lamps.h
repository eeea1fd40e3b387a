// Lamps without extent: points, spots and suns. A point of a surface sees such a lamp in one direction alone,
// so one shadow ray tells its light without noise.
#pragma once

#include <vector>

#include "render/lights/incident_light.h"
#include "scene/scene.h"

namespace saccade {

class DeltaLamps {
 public:
  explicit DeltaLamps(const Scene& scene);

  static constexpr std::size_t kMost = 16;  // more are left to the samples of paths

  // Whether there are any, and no more than that.
  bool areFew() const { return size() > 0 && size() <= kMost; }
  std::size_t size() const { return spots_.size() + suns_.size(); }

  // The light of a lamp at `point`. Its pdf has no meaning.
  IncidentLight at(std::size_t lamp, Vec3 point) const;

 private:
  std::vector<SpotLight> spots_;  // a point is one that shines everywhere
  std::vector<DirectionalLight> suns_;
};

}  // namespace saccade
