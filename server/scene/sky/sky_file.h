// The file sky.toml beside a scene's file of glTF, OBJ or PLY. Where it stands, the scene has this sky alone:
//   radiance = [0.5, 0.6, 0.9]   # of all directions, or one number for all three colours; 1 by default
//   picture = "sky.exr"          # as Environment::picture, in the same folder or below; radiance is a factor
//   turn = 90                    # degrees about +y, counter-clockwise as seen from above; 0 by default
#pragma once

#include <filesystem>

#include "scene/files/file_loads.h"
#include "scene/files/load_options.h"
#include "scene/scene.h"

namespace saccade {

inline constexpr const char* kSkyFile = "sky.toml";

// Sets Scene::environment, if there is such a file beside `scene_file`, and returns whether there is. `loads`
// will read its picture while `scene` stands. Throws SceneError with file and line, and what would be valid.
bool addSkyFile(const std::filesystem::path& scene_file, const LoadOptions& options, FileLoads& loads,
                Scene& scene);

}  // namespace saccade
