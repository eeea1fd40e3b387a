#include "scene/library/find_scenes.h"

#include <filesystem>
#include <system_error>

namespace saccade {

std::string findScenes() {
  std::error_code none;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", none);
  const auto installed = program.parent_path().parent_path() / "share/saccade/scenes";
  return std::filesystem::is_directory(installed, none) ? installed.string() : SACCADE_SCENES;
}

}  // namespace saccade
