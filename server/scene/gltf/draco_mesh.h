// Meshes of KHR_draco_mesh_compression.
#pragma once

#include <string>

#include "scene/gltf/gltf_buffers.h"
#include "scene/scene.h"

namespace saccade {

// `coded`: the extension of a part of a mesh. `uvs`: the name of the attribute of its texture coordinates.
// The result is as that of readPrimitive(). Throws SceneError.
Mesh readDraco(const JsonNode& coded, const GltfBuffers& buffers, const std::string& uvs);

}  // namespace saccade
