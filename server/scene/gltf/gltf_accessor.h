// Arrays of numbers of a glTF file [glTF 2.0, 3.6.2].
#pragma once

#include <cstdint>
#include <vector>

#include "scene/gltf/gltf_buffers.h"

namespace saccade {

// All throw SceneError.

// How many elements accessors[i] has. Reads no bytes.
std::size_t accessorCount(const JsonNode& root, std::size_t i);

// The numbers of accessors[i], element by element. Each has `components`. Whole numbers become fractions of
// their largest value where the accessor says so. Sparse values are in their places.
std::vector<float> readFloats(const JsonNode& root, const GltfBuffers& buffers, std::size_t i,
                              std::size_t components);

// Indices of vertices, each below `vertices`.
std::vector<std::uint32_t> readIndices(const JsonNode& root, const GltfBuffers& buffers, std::size_t i,
                                       std::size_t vertices);

}  // namespace saccade
