// The nodes of a glTF scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/deformation/moving_node.h"
#include "scene/gltf/json_node.h"

namespace saccade {

struct GltfNode {
  std::size_t index;  // in the file
  JsonNode json;
  std::optional<std::size_t> parent;  // in the list of nodes
  std::string name;                   // its own; else that of its mesh; unique
  LocalTransform rest;                // as the file has it, without animation
};

// The default scene, or the first; none where the file has no scene. Throws SceneError.
std::optional<JsonNode> sceneOf(const JsonNode& root);

// The property "rotation", of unit length; no rotation where it is absent. Throws SceneError.
Quaternion readRotation(const JsonNode& json);

// The nodes of the default scene, or of the first, or of the whole file where it has no scene. Parents come
// before their children. Throws SceneError.
std::vector<GltfNode> readNodes(const JsonNode& root);

}  // namespace saccade
