// Bytes of EXT_meshopt_compression.
#pragma once

#include <string>
#include <string_view>

#include "scene/gltf/json_node.h"

namespace saccade {

// `coded`: the extension of a buffer view. Both throw SceneError.

// How many bytes it holds.
std::size_t decodedBytes(const JsonNode& coded);
// They, from those that it names.
std::string decodeMeshopt(const JsonNode& coded, std::string_view bytes);

}  // namespace saccade
