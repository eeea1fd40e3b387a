#include "scene/files/toml_file.h"

#include "scene/files/confinement.h"
#include "scene/files/plain_file.h"
#include "scene/files/scene_error.h"

namespace saccade {

std::optional<toml::table> readToml(const std::filesystem::path& file, std::size_t max_bytes,
                                    const LoadOptions& options) {
  std::error_code other;
  if (std::filesystem::symlink_status(file, other).type() == std::filesystem::file_type::not_found) return {};
  if (!mayRead(file, options.confined_to))
    throw SceneError(file.string() + " leads out of the folder of the scenes");
  try {
    return toml::parse(readFile(file.string(), max_bytes), file.string());
  } catch (const toml::parse_error& fault) {
    throw SceneError(file.string(), static_cast<long>(fault.source().begin.line),
                     std::string(fault.description()));
  }
}

}  // namespace saccade
