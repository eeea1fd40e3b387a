// Finds the files that a scene names.
#pragma once

#include <filesystem>
#include <string>

#include "scene/files/load_options.h"

namespace saccade {

// Returns the path of the file called `name`: relative to `folder`, which holds the scene's own file, or else
// to one of the search folders. Throws SceneError where it is in none of them, or where the scene may not
// read it. Without search folders the path may lead to no file.
std::string findFile(const std::string& name, const std::filesystem::path& folder,
                     const LoadOptions& options);

}  // namespace saccade
