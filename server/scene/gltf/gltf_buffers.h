// The bytes that a glTF file names.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "scene/gltf/gltf_file.h"

namespace saccade {

// Once read, it may be used from any thread.
class GltfBuffers {
 public:
  // Keeps a reference to `file`. Reads all buffers, and decodes the views of EXT_meshopt_compression. Throws
  // SceneError, also where the buffers have more than kMaxMeshBytes together.
  explicit GltfBuffers(const GltfFile& file);

  // The bytes of bufferViews[i], and those from one element to the next; 0: not said.
  struct View {
    std::string_view bytes;
    std::size_t stride;
  };
  View view(std::size_t i) const;
  std::size_t bytes() const { return bytes_; }  // of all together

 private:
  void take(const JsonNode& at, std::size_t count, std::size_t most);
  std::string_view part(const JsonNode& view) const;

  const GltfFile& file_;
  std::vector<std::string> buffers_;
  std::map<std::size_t, std::string> decoded_;  // views, by index
  std::size_t bytes_ = 0;
};

}  // namespace saccade
