// A mesh of KHR_draco_mesh_compression.
#pragma once

#include <memory>

#include "scene/gltf/gltf_primitive.h"

namespace draco {
class Mesh;
}

namespace saccade {

class DracoMesh {
 public:
  // Decodes all. `coded`: the extension of a part of a mesh. Throws SceneError, as all members do.
  DracoMesh(const JsonNode& coded, const GltfBuffers& buffers);
  ~DracoMesh();

  Mesh mesh(const UvSets& uv_sets) const;  // as readPrimitive()
  // Four finite numbers a vertex; empty where there is no such attribute.
  std::vector<float> fours(const std::string& name) const;

 private:
  const JsonNode coded_;
  std::unique_ptr<draco::Mesh> decoded_;
};

}  // namespace saccade
