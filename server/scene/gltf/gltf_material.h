// One material of a glTF file.
#pragma once

#include "scene/gltf/gltf_pictures.h"
#include "scene/gltf/gltf_primitive.h"

namespace saccade {

struct GltfMaterial {
  Material material;
  UvSets uv_sets = {};      // of its textures
  Rgb emission{};           // radiance, times Material::emission
  bool emits_back = false;  // from both sides
};

// `json`: an empty object for glTF's default material. Adds sentences on what is not shown to `unread`.
// Throws SceneError.
GltfMaterial readMaterial(const JsonNode& json, const std::string& name, GltfPictures& pictures,
                          std::vector<std::string>& unread);

}  // namespace saccade
