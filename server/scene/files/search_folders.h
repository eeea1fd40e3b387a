// The folders of meshes that scenes name and do not hold, as `saccaded --meshes` and SACCADE_MESHES give
// them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace saccade {

// The default of the setting. The Debian package glmark2-data puts the Stanford bunny there.
inline constexpr const char* kDefaultMeshes = "/usr/share/glmark2/models";

// The folders of a list "FOLDER:FOLDER"; empty parts are left out.
std::vector<std::filesystem::path> splitFolders(const std::string& list);

// "FOLDER, FOLDER" for a message that no folder holds `file`, or "none"; says which package has the bunny.
std::string describeFolders(const std::vector<std::filesystem::path>& folders, const std::string& file);

}  // namespace saccade
