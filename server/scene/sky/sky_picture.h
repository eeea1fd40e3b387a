// The picture of a sky, for a reader of any format.
#pragma once

#include <string>

#include "scene/files/file_loads.h"
#include "scene/scene.h"

namespace saccade {

// Lets `loads` read Scene::environment's picture, while `scene` stands. `located`: see FileLoads::add().
void addSkyPicture(FileLoads::Locate located, const std::string& path, FileLoads& loads, Scene& scene);

}  // namespace saccade
