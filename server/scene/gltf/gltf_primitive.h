// A part of a mesh of a glTF file, of one material.
#pragma once

#include "scene/gltf/gltf_buffers.h"
#include "scene/scene.h"

namespace saccade {

// Whether a part has triangles, rather than points or lines. Throws SceneError.
bool hasTriangles(const JsonNode& part);

// Positions, triangles, and normals and the texture coordinates TEXCOORD_<set> where the part has them. In
// the space of its node, without the spare position. Throws SceneError.
Mesh readPrimitive(const JsonNode& root, const GltfBuffers& buffers, const JsonNode& part,
                   std::size_t coordinates);

}  // namespace saccade
