#include "scene/sky/sky_picture.h"

namespace saccade {

void addSkyPicture(FileLoads::Locate located, const std::string& path, FileLoads& loads, Scene& scene) {
  loads.add(std::move(located), [&loads, &scene, path] {
    loads.takePixels(countPixels(path));
    scene.environment->picture = loadPicture(path, PixelUse::kRadiance);
  });
}

}  // namespace saccade
