// The free space around the surfaces of a scene, for paths that keep a distance from them.
#pragma once

#include <span>

#include "base/vec.h"

namespace saccade {

// World axes, scene units. Equal questions get equal answers on any thread.
class FreeSpace {
 public:
  virtual ~FreeSpace() = default;

  // To the nearest surface; `reach` where none is nearer than that.
  virtual double distance(Vec3d point, double reach) const = 0;

  // How far each of the directions, of length 1, goes on to the first surface; infinity where there is none.
  // There are as many distances as directions.
  virtual void look(Vec3d from, std::span<const Vec3d> directions, std::span<double> distances) const = 0;
};

}  // namespace saccade
