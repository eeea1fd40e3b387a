// The meshes of a glTF file.
#pragma once

#include "scene/files/file_loads.h"
#include "scene/gltf/gltf_buffers.h"
#include "scene/gltf/gltf_materials.h"
#include "scene/gltf/gltf_nodes.h"

namespace saccade {

// All members throw SceneError.
class GltfMeshes {
 public:
  // Adds meshes to `scene`, which `loads` will read. They cannot run without `buffers`.
  GltfMeshes(const JsonNode& root, const GltfBuffers* buffers, GltfMaterials& materials, FileLoads& loads,
             Scene& scene)
      : root_(root), buffers_(buffers), materials_(materials), loads_(loads), scene_(scene) {}

  // A mesh for each part of the mesh of a node. All are called `name`.
  void add(const GltfNode& node, const std::string& name, const Affine& to_world);

 private:
  void addPart(const JsonNode& part, const std::string& name, const Affine& to_world);
  void count(const JsonNode& part);

  const JsonNode root_;
  const GltfBuffers* buffers_;
  GltfMaterials& materials_;
  FileLoads& loads_;
  Scene& scene_;
  std::size_t corners_ = 0, vertices_ = 0;  // of all parts
};

}  // namespace saccade
