// The materials of a glTF file.
#pragma once

#include "scene/gltf/gltf_material.h"

namespace saccade {

// All members throw SceneError.
class GltfMaterials {
 public:
  // Adds the materials that it reads to `scene`.
  GltfMaterials(const JsonNode& root, GltfPictures& pictures, Scene& scene)
      : root_(root), pictures_(pictures), scene_(scene) {}

  // The index in Scene::materials of materials[i] of the file, or of glTF's default material.
  int read(std::optional<std::size_t> i);
  // The texture coordinates of one of Scene::materials.
  const UvSets& uvSets(int material) const { return read_[static_cast<std::size_t>(material)].uv_sets; }
  // Gives meshes the light of their materials, once pictures have been read. Open ones that emit from both
  // sides get a second mesh for their back.
  void setEmission();

 private:
  const JsonNode root_;
  GltfPictures& pictures_;
  Scene& scene_;
  std::map<std::optional<std::size_t>, int> index_;
  std::vector<GltfMaterial> read_;  // as Scene::materials
};

}  // namespace saccade
