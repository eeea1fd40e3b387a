// Resolves the path of a request.
#pragma once

#include <stop_token>

#include "app/request/resolved_stream.h"
#include "scene/camera/trajectory.h"
#include "scene/library/scene_library.h"

namespace saccade {

class RenderScene;

// Checks what needs no loaded scene, fills in the defaults, and reads keyframes and csv. Throws Refusal, with
// the line of a faulty text.
void checkTrajectory(ResolvedStream& stream, const SceneEntry& scene);

// The body's path, once the field of view is known. Throws Refusal; Cancelled once `stop` is requested.
Trajectory resolveTrajectory(const ResolvedStream& stream, const RenderScene& scene,
                             const SceneLibrary& library, const std::stop_token& stop = {});

}  // namespace saccade
