// The addresses of files in glTF [RFC 3986, RFC 2397].
#pragma once

#include <string>

#include "scene/gltf/json_node.h"

namespace saccade {

// The path that a relative address names: %20 is a blank.
std::string decodedPath(const std::string& uri);

// Whether the address holds the bytes itself, as base64.
bool isData(const std::string& uri);
// Those bytes. Throws SceneError.
std::string decodeData(const JsonNode& at, const std::string& uri);

}  // namespace saccade
