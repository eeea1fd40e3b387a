// The nodes of a glTF scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/affine.h"
#include "scene/camera/pose.h"
#include "scene/gltf/json_node.h"

namespace saccade {

// From the space of a node to that of its parent: scaled, then turned, then moved. Instead of these, a
// matrix.
struct LocalTransform {
  Vec3d translation;
  Quaternion rotation;
  Vec3d scale{1, 1, 1};
  std::optional<Affine> matrix = {};

  Affine affine() const;
};

struct GltfNode {
  std::size_t index;  // in the file
  JsonNode json;
  std::optional<std::size_t> parent;  // in the list of nodes
  std::string name;                   // its own; else that of its mesh; unique
  LocalTransform rest;                // as the file has it, without animation
};

// The nodes of the default scene, or of the first, or of the whole file where it has no scene. Parents come
// before their children. Throws SceneError.
std::vector<GltfNode> readNodes(const JsonNode& root);

}  // namespace saccade
