// A glTF 2.0 file, as text (.gltf) or binary (.glb), and the files that it names.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "scene/files/load_options.h"
#include "scene/gltf/json_node.h"

namespace saccade {

// All members throw SceneError.
class GltfFile {
 public:
  // Reads the JSON alone. Refuses another version than 2, and required extensions that are not supported.
  GltfFile(const std::string& path, const LoadOptions& options);
  GltfFile(const GltfFile&) = delete;

  const std::string& path() const { return path_; }
  JsonNode root() const { return {json_, path_}; }

  // The path of the file at a relative `uri`, which findFile() looks up.
  std::string locate(const JsonNode& at, const std::string& uri) const;
  // The first `count` bytes at a `uri`, a file or base64 within the text.
  std::string readUri(const JsonNode& at, const std::string& uri, std::size_t count) const;
  // The same of the binary part of a .glb. Empty where there is none.
  std::string readBinary(const JsonNode& at, std::size_t count) const;

 private:
  std::string readJson();  // finds the binary part, too

  const std::string path_;
  const LoadOptions& options_;
  nlohmann::json json_;
  std::size_t binary_begin_ = 0, binary_bytes_ = 0;  // in the file
};

}  // namespace saccade
