// The file around the meshes of a serialized file of Mitsuba. Each mesh has a header and is compressed on its
// own; a list at the end says where they begin.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace saccade {

// Bytes of a file, of which only parts are read.
struct FileParts {
  std::size_t size;
  std::function<std::string(std::size_t offset, std::size_t bytes)> read;
};

struct SerializedMesh {
  int version;  // 3 or 4
  std::string compressed;
};

// The mesh with this index, which counts from 0. Throws SceneError: no such file, version or index, or a
// faulty list.
SerializedMesh readSerializedMesh(const FileParts& file, const std::string& path, int index);

}  // namespace saccade
