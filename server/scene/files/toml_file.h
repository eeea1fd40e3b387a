// Reads TOML files of a scene's folder.
#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <optional>

#include "scene/files/load_options.h"

namespace saccade {

// None where nothing has this path; a link that leads nowhere counts as something. Throws SceneError with
// file and line: faulty TOML, more than `max_bytes`, or a file that a scene may not read.
std::optional<toml::table> readToml(const std::filesystem::path& file, std::size_t max_bytes,
                                    const LoadOptions& options);

}  // namespace saccade
