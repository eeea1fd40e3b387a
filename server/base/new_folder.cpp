#include "base/new_folder.h"

#include <unistd.h>

#include <filesystem>

namespace saccade {
namespace {

namespace fs = std::filesystem;

// `path`, or the folder above it that is there.
fs::path thereOf(fs::path path) {
  std::error_code none;
  while (!fs::exists(path, none) && path.has_relative_path()) path = path.parent_path();
  return path.empty() ? "." : path;
}

}  // namespace

std::string newFolderFault(const std::string& path) {
  if (path.empty()) return {};
  const fs::path there = thereOf(path);
  if (!fs::is_directory(there)) return "'" + there.string() + "' is not a folder";
  if (access(there.c_str(), W_OK) != 0) return "the folder '" + there.string() + "' cannot be written";
  return {};
}

}  // namespace saccade
