// Resolves the views of a request.
#pragma once

#include <string>

#include "saccade/v1/control.pb.h"
#include "scene/camera/lens.h"
#include "scene/scene.h"

namespace saccade {

// The camera of the view at `field`; without its focal length where the request leaves that to the scene.
// Throws Refusal.
CameraModel resolveView(const v1::View& view, const std::string& field);
// Fills in the scene's field of view where the request has neither that nor intrinsics. Throws Refusal.
CameraModel fitView(const Scene& scene, v1::View& view, const std::string& field);

}  // namespace saccade
