// A part of a mesh of a glTF file, of one material.
#pragma once

#include <optional>

#include "scene/gltf/gltf_accessor.h"
#include "scene/scene.h"

namespace saccade {

// The texture coordinates that a mesh keeps, as numbers of TEXCOORD: Mesh::uvs and Mesh::second_uvs.
struct UvSets {
  std::size_t first = 0;
  std::optional<std::size_t> second = {};
};

std::string texCoord(std::size_t set);  // the name of the attribute

// Whether a part has triangles, rather than points or lines. Throws SceneError.
bool hasTriangles(const JsonNode& part);

// Positions, triangles, and normals, the colours COLOR_0 and the texture coordinates where the part has them.
// In the space of its node, without the spare position. Throws SceneError.
Mesh readPrimitive(const JsonNode& root, const GltfBuffers& buffers, const JsonNode& part,
                   const UvSets& uv_sets);

// An attribute or a part of a morph target, by its name in `attributes`, for each vertex. Empty where there
// is none. Numbers are finite. Throws SceneError.
std::vector<float> readAttribute(const JsonNode& root, const GltfBuffers& buffers, const JsonNode& attributes,
                                 const std::string& name, std::size_t components, std::size_t vertices);
std::vector<Vec3> readVectors(const JsonNode& root, const GltfBuffers& buffers, const JsonNode& attributes,
                              const std::string& name, std::size_t vertices);

}  // namespace saccade
