// The arrays of skins and morph targets of a glTF file [glTF 2.0, 3.7.2.2, 3.7.3].
#pragma once

#include <functional>

#include "scene/gltf/gltf_buffers.h"
#include "scene/scene.h"

namespace saccade {

// All throw SceneError.

// How many targets the parts of a mesh have at most.
std::size_t targetCount(const JsonNode& mesh);

// For each joint of a skin the map from the space of the mesh to that of the joint's node.
std::vector<Affine> readBinds(const JsonNode& root, const GltfBuffers& buffers, std::size_t skin,
                              std::size_t joints);

// Of a part of a mesh, which has been read into `mesh`. Normals are those of the vertices that have some.
std::vector<MorphTarget> readTargets(const JsonNode& root, const GltfBuffers& buffers, const JsonNode& part,
                                     const Mesh& mesh);

// Reads an attribute of four finite numbers a vertex, by its name; empty where there is none.
using ReadFours = std::function<std::vector<float>(const std::string& name)>;

// See Deformation::influences. A vertex has four joints for each set of JOINTS that the part has, up to 16.
std::vector<Influence> readInfluences(const JsonNode& part, const ReadFours& read, std::size_t vertices,
                                      std::size_t joints);

}  // namespace saccade
