// Serialized meshes of Mitsuba, as its manual lays them out.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <string>
#include <vector>

namespace saccade::test {

template <class T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

inline std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string out(size, '\0');
  compress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
           bytes.size());
  out.resize(size);
  return out;
}

struct SerializedLayout {
  int version = 4;
  bool doubles = false, normals = true, uvs = true, colours = false;

  std::uint32_t flags() const {
    return (doubles ? 0x2000u : 0x1000u) | (normals ? 1u : 0) | (uvs ? 2u : 0) | (colours ? 8u : 0);
  }
};

// The data, not yet compressed, of a triangle (0, 0, 0), (1, 0, 0), (0, `height`, 0) with normal +z.
inline std::string triangleData(const SerializedLayout& layout, double height, std::uint64_t vertices = 3,
                                std::uint64_t triangles = 1, std::uint32_t last_corner = 2) {
  std::string data;
  append(data, layout.flags());
  if (layout.version == 4) data += std::string("a name") + '\0';
  append(data, vertices), append(data, triangles);
  std::vector<double> numbers = {0, 0, 0, 1, 0, 0, 0, height, 0};
  if (layout.normals) numbers.insert(numbers.end(), {0, 0, 1, 0, 0, 1, 0, 0, 1});
  if (layout.uvs) numbers.insert(numbers.end(), {0, 0, 1, 0, 0.25, 0.75});
  if (layout.colours) numbers.insert(numbers.end(), 9, 0.5);
  for (const double n : numbers) layout.doubles ? append(data, n) : append(data, static_cast<float>(n));
  for (const std::uint32_t corner : {0u, 1u, last_corner}) append(data, corner);
  return data;
}

// A file of these meshes, before they are compressed.
inline std::string serializedFile(int version, const std::vector<std::string>& meshes) {
  std::string file, list;
  for (const std::string& mesh : meshes) {
    version == 3 ? append(list, static_cast<std::uint32_t>(file.size()))
                 : append(list, static_cast<std::uint64_t>(file.size()));
    append(file, std::uint16_t{0x041c}), append(file, static_cast<std::uint16_t>(version));
    file += deflated(mesh);
  }
  file += list;
  append(file, static_cast<std::uint32_t>(meshes.size()));
  return file;
}

}  // namespace saccade::test
