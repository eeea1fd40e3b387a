// The textures of a glTF file.
#pragma once

#include <map>
#include <tuple>

#include "scene/files/file_loads.h"
#include "scene/gltf/gltf_buffers.h"
#include "scene/scene.h"

namespace saccade {

// The use of a picture, which is multiplied by the factor.
struct PictureUse {
  enum class Kind {
    kColor,     // sRGB
    kCoverage,  // the alpha
    kCutOut,    // 1 where the alpha is at least `threshold`, 0 elsewhere
    kNumbers,   // linear
    kEmission,  // sRGB, a texture of its own: GltfMaterials changes it
  };
  Kind kind = Kind::kColor;
  Rgb factor{1, 1, 1};
  float threshold = 0;  // of alpha times the factor
  Texture::Wrap wrap_u = Texture::Wrap::kRepeat, wrap_v = Texture::Wrap::kRepeat;  // of the texture

  auto key() const { return std::tuple(kind, factor.x, factor.y, factor.z, threshold, wrap_u, wrap_v); }
};

// All members throw SceneError.
class GltfPictures {
 public:
  // Adds textures to `scene`, which `loads` will read while this stands. Without `buffers` they cannot run.
  GltfPictures(const GltfFile& file, const GltfBuffers* buffers, FileLoads& loads, Scene& scene)
      : file_(file), buffers_(buffers), loads_(loads), scene_(scene) {}

  // A texture that a material names: `info` has an index.
  SurfaceColor read(const JsonNode& info, PictureUse use);
  // The set of texture coordinates that it uses.
  static std::size_t coordinates(const JsonNode& info);

 private:
  JsonNode imageOf(const JsonNode& texture) const;
  PictureFile sourceOf(const JsonNode& image);
  int add(const JsonNode& image, const PictureUse& use);

  const GltfFile& file_;
  const GltfBuffers* buffers_;
  FileLoads& loads_;
  Scene& scene_;
  using Key = decltype(std::tuple_cat(std::tuple<std::string>(), PictureUse().key()));
  std::map<Key, int> added_;                 // by the place of the image
  std::map<std::string, std::string> data_;  // pictures within the text
};

}  // namespace saccade
