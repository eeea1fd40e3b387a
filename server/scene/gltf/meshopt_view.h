// Bytes of EXT_meshopt_compression.
#pragma once

#include <string>
#include <string_view>

#include "scene/gltf/json_node.h"

namespace saccade {

// `coded`: the extension of a buffer view, and the bytes that it names. Throws SceneError.
std::string decodeMeshopt(const JsonNode& coded, std::string_view bytes);

}  // namespace saccade
