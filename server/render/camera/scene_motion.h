// Motions in a scene that is ready for tracing.
#pragma once

#include <stop_token>

#include "render/world/render_scene.h"
#include "scene/camera/lens.h"
#include "scene/camera/motion.h"

namespace saccade {

// makeMotion() with what is in view at the start, or makeRoam() in the free space of the scene. Throws
// NoRoom; Cancelled once `stop` is requested.
Trajectory motionIn(const RenderScene& scene, const Motion& motion, const Pose& start, const Lens& lens,
                    const std::stop_token& stop = {});

}  // namespace saccade
