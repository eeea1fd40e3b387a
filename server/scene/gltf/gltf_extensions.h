// Extensions of glTF.
#pragma once

#include <string>
#include <vector>

#include "scene/gltf/json_node.h"

namespace saccade {

// Throws SceneError where the file requires an extension that is not supported; names it, and those that are.
void requireExtensions(const JsonNode& root);
// Sentences on further extensions that the file uses. They change the picture, and are not read.
std::vector<std::string> unreadExtensions(const JsonNode& root);

}  // namespace saccade
