#include "render/camera/scene_motion.h"

#include "render/camera/view_grid.h"
#include "render/world/scene_space.h"
#include "scene/roam/roam.h"

namespace saccade {

Trajectory motionIn(const RenderScene& scene, const Motion& motion, const Pose& start, const Lens& lens,
                    const std::stop_token& stop) {
  if (motion.kind == kRoam) return makeRoam(motion, start, SceneSpace(scene), lens, stop);
  return makeMotion(motion, start, probePoints(scene, start, lens), lens);
}

}  // namespace saccade
