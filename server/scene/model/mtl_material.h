// Materials of the scene from those of an MTL file.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "scene/files/file_loads.h"
#include "scene/model/mtl_file.h"
#include "scene/scene.h"

namespace saccade {

// Adds pictures to the textures of a scene, one for each file. Both outlive this. All throw SceneError.
class MtlPictures {
 public:
  MtlPictures(Scene& scene, const LoadOptions& options) : scene_(scene), options_(options) {}

  // `mtl` is the path of the file that names the picture. read() will read it.
  SurfaceColor add(const std::string& mtl, const MtlMaterial::Map& map, PixelUse use);
  void read() { loads_.run(options_); }

 private:
  int numberOf(const std::string& path, PixelUse use, const FileLoads::Locate& told);

  Scene& scene_;
  const LoadOptions& options_;
  FileLoads loads_;
  std::map<std::pair<std::string, PixelUse>, int> numbers_;
};

// See model_scene.h. `path` is that of the MTL file.
Material materialOf(const MtlMaterial& mtl, const std::string& path, MtlPictures& pictures);

}  // namespace saccade
