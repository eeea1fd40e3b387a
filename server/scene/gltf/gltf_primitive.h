// A part of a mesh of a glTF file, of one material.
#pragma once

#include "scene/gltf/gltf_accessor.h"
#include "scene/scene.h"

namespace saccade {

// Whether a part has triangles, rather than points or lines. Throws SceneError.
bool hasTriangles(const JsonNode& part);

// Positions, triangles, and normals, the colours COLOR_0 and the texture coordinates TEXCOORD_<set> where the
// part has them. In the space of its node, without the spare position. Throws SceneError.
Mesh readPrimitive(const JsonNode& root, const GltfBuffers& buffers, const JsonNode& part,
                   std::size_t coordinates);

// An attribute or a part of a morph target, by its name in `attributes`, for each vertex. Empty where there
// is none. Numbers are finite. Throws SceneError.
std::vector<float> readAttribute(const JsonNode& root, const GltfBuffers& buffers, const JsonNode& attributes,
                                 const std::string& name, std::size_t components, std::size_t vertices);
std::vector<Vec3> readVectors(const JsonNode& root, const GltfBuffers& buffers, const JsonNode& attributes,
                              const std::string& name, std::size_t vertices);

}  // namespace saccade
