// Confines the files that a scene may read.
#pragma once

#include <filesystem>
#include <vector>

namespace saccade {

// Whether `file`, with its links and dots followed, is one of `places` or lies below one of them. Without any
// place every file may be read. Throws SceneError where links cannot be followed.
bool mayRead(const std::filesystem::path& file, const std::vector<std::filesystem::path>& places);

}  // namespace saccade
