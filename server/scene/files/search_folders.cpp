#include "scene/files/search_folders.h"

#include <sstream>

#include "base/names.h"

namespace saccade {

std::vector<std::filesystem::path> splitFolders(const std::string& list) {
  std::vector<std::filesystem::path> folders;
  std::istringstream rest(list);
  for (std::string folder; std::getline(rest, folder, ':');)
    if (!folder.empty()) folders.emplace_back(folder);
  return folders;
}

std::string describeFolders(const std::vector<std::filesystem::path>& folders, const std::string& file) {
  std::vector<std::string> names;
  for (const auto& folder : folders) {
    const bool is_packaged = folder == kDefaultMeshes && file == "bunny.obj";
    names.push_back(folder.string() + (is_packaged ? " (install the Debian package glmark2-data)" : ""));
  }
  return joinNames(names);
}

}  // namespace saccade
