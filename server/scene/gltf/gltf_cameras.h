// The cameras of a glTF file.
#pragma once

#include "scene/gltf/gltf_animation.h"
#include "scene/scene.h"

namespace saccade {

// Each perspective camera is a path of the scene, by the name of its node. The first is the scene's own
// camera, too. Before the animation's keys have been read, the paths stand. Throws SceneError.
void readCameras(const JsonNode& root, const std::vector<GltfNode>& nodes, const GltfAnimation& animation,
                 Scene& scene);

}  // namespace saccade
