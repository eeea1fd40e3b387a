// The meshes of a glTF file.
#pragma once

#include "scene/files/file_loads.h"
#include "scene/gltf/gltf_forms.h"
#include "scene/gltf/gltf_materials.h"

namespace saccade {

// All members throw SceneError.
class GltfMeshes {
 public:
  // Adds meshes to `scene`, which `loads` will read. They cannot run without `buffers`.
  GltfMeshes(const JsonNode& root, const GltfBuffers* buffers, GltfMaterials& materials,
             const GltfForms& forms, FileLoads& loads, Scene& scene)
      : root_(root), buffers_(buffers), materials_(materials), forms_(forms), loads_(loads), scene_(scene) {}

  // How the mesh of a node is called, where it is at stream time 0, and what changes its form.
  struct Placed {
    std::string name;
    Affine to_scene;
    std::optional<GltfForm> form;
  };
  // A mesh for each part of the mesh of a node.
  void add(const GltfNode& node, const Placed& placed);

 private:
  void addPart(const JsonNode& part, Placed placed);
  void load(const JsonNode& part, const Placed& placed, const UvSets& uv_sets, Mesh& outline) const;
  void count(const JsonNode& part);

  const JsonNode root_;
  const GltfBuffers* buffers_;
  GltfMaterials& materials_;
  const GltfForms& forms_;
  FileLoads& loads_;
  Scene& scene_;
  std::size_t corners_ = 0, vertices_ = 0;  // of all parts
};

}  // namespace saccade
