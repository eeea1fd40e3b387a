// Lamps without extent: points and directions. A point of a surface sees such a lamp in one direction alone, so
// one shadow ray tells its light without noise.
#pragma once

#include "render/lights/lights.h"

namespace saccade {

class DeltaLamps {
 public:
  explicit DeltaLamps(const Scene& scene) : points_(scene.point_lights), suns_(scene.directional_lights) {}

  bool empty() const { return size() == 0; }
  std::size_t size() const { return points_.size() + suns_.size(); }

  // The light of a lamp at `point`. Its pdf has no meaning.
  IncidentLight at(std::size_t lamp, Vec3 point) const;

 private:
  std::vector<PointLight> points_;
  std::vector<DirectionalLight> suns_;
};

}  // namespace saccade
