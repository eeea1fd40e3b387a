#include "scene/files/find_file.h"

#include "scene/files/confinement.h"
#include "scene/files/scene_error.h"
#include "scene/files/search_folders.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;

bool isThere(const fs::path& file, const LoadOptions& options) {
  if (!mayRead(file, options.confined_to))
    throw SceneError("the file " + file.string() + " leads out of the folder of the scenes");
  std::error_code absent;
  return fs::exists(file, absent);
}

}  // namespace

std::string findFile(const std::string& name, const fs::path& folder, const LoadOptions& options) {
  const fs::path beside = folder / name;
  if (isThere(beside, options) || options.search_folders.empty()) return beside.string();
  for (const fs::path& other : options.search_folders)
    if (isThere(other / name, options)) return (other / name).string();
  throw SceneError("the file " + beside.string() +
                   " is absent, and no folder of <path>, --meshes or SACCADE_MESHES holds it: " +
                   describeFolders(options.search_folders, name));
}

}  // namespace saccade
