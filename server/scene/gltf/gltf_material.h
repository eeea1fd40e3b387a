// One material of a glTF file.
#pragma once

#include "scene/gltf/gltf_pictures.h"

namespace saccade {

struct GltfMaterial {
  Material material;
  std::size_t coordinates = 0;  // the set of texture coordinates of its textures: the number of TEXCOORD
  Rgb emission{};               // radiance
  bool emits_back = false;      // from both sides
  int emission_texture = -1;    // of Scene::textures: a factor of one pixel; -1: none
};

// `json`: an empty object for glTF's default material. Adds sentences on what is not shown to `unread`.
// Throws SceneError.
GltfMaterial readMaterial(const JsonNode& json, const std::string& name, GltfPictures& pictures,
                          std::vector<std::string>& unread);

}  // namespace saccade
