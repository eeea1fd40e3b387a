#include "scene/roam/course.h"

#include "scene/camera/spline_path.h"

namespace saccade {

Pose Course::at(double u) const {
  const auto along = [&](const std::vector<Vec3d>& loop) {
    return loopAt(loop, u * static_cast<double>(loop.size()));
  };
  return {along(places), level.rotation(along(gaze))};
}

}  // namespace saccade
