#include <algorithm>
#include <array>
#include <cmath>

#include "scene/files/limits.h"
#include "scene/files/plain_file.h"
#include "scene/files/scene_error.h"
#include "scene/mesh/inflate.h"
#include "scene/mesh/mesh_io.h"
#include "scene/mesh/serialized_file.h"

namespace saccade {
namespace {

constexpr std::size_t kBlock = 4096;  // vertices or triangles that are read at once

enum Flags : std::uint32_t { kNormals = 1, kUvs = 2, kColours = 8, kDoubles = 0x2000 };

class SerializedReader {
 public:
  explicit SerializedReader(const std::string& path) : path_(path) {}
  Mesh read(const SerializedMesh& mesh);

 private:
  void readVertices(Inflate& data, std::uint32_t flags, std::size_t count);
  template <std::size_t N, class Store>
  void readTuples(Inflate& data, std::uint32_t flags, std::size_t count, Store store) const;
  void readTriangles(Inflate& data, std::size_t count);
  [[noreturn]] void fail(const std::string& what) const { throw SceneError(path_ + ": " + what); }

  const std::string& path_;
  Mesh mesh_;
};

template <class T>
T take(Inflate& data) {
  T value;
  data.read(&value, sizeof value);
  return value;
}

Mesh SerializedReader::read(const SerializedMesh& mesh) {
  Inflate data(mesh.compressed, path_);
  const auto flags = take<std::uint32_t>(data);
  if (mesh.version == 4)
    while (take<char>(data) != 0) continue;  // the name that its author gave it
  const auto vertices = take<std::uint64_t>(data), triangles = take<std::uint64_t>(data);
  if (triangles == 0) fail("the mesh has no triangles");
  if (triangles > kMaxTriangles || vertices > 3 * kMaxTriangles)
    fail("more than " + std::to_string(kMaxTriangles) + " triangles");
  readVertices(data, flags, vertices);
  readTriangles(data, triangles);
  if (flags & kColours)
    mesh_.unread = path_ + ": its colours are not read; the shape is grey without a <bsdf>";
  return std::move(mesh_);
}

void SerializedReader::readVertices(Inflate& data, std::uint32_t flags, std::size_t count) {
  readTuples<3>(data, flags, count, [&](const auto& v) { mesh_.positions.push_back({v[0], v[1], v[2]}); });
  if (flags & kNormals)
    readTuples<3>(data, flags, count, [&](const auto& v) { mesh_.normals.push_back({v[0], v[1], v[2]}); });
  if (flags & kUvs)
    readTuples<2>(data, flags, count, [&](const auto& v) { mesh_.uvs.push_back({v[0], v[1]}); });
  if (flags & kColours) readTuples<3>(data, flags, count, [](const auto&) {});
}

// `store` takes each tuple of N numbers, of which the file has one for each vertex.
template <std::size_t N, class Store>
void SerializedReader::readTuples(Inflate& data, std::uint32_t flags, std::size_t count, Store store) const {
  const auto readAs = [&](auto number) {
    std::vector<std::array<decltype(number), N>> block(std::min(kBlock, count));
    for (std::size_t done = 0; done < count; done += block.size()) {
      block.resize(std::min(kBlock, count - done));
      data.read(block.data(), block.size() * sizeof block[0]);
      for (const auto& tuple : block) {
        std::array<float, N> v;
        std::transform(tuple.begin(), tuple.end(), v.begin(), [](auto n) { return static_cast<float>(n); });
        if (!std::all_of(v.begin(), v.end(), [](float n) { return std::isfinite(n); }))
          fail("a number of a vertex is not finite");
        store(v);
      }
    }
  };
  if (flags & kDoubles) {
    readAs(0.0);
  } else {
    readAs(0.0f);
  }
}

void SerializedReader::readTriangles(Inflate& data, std::size_t count) {
  auto& triangles = mesh_.triangles;
  while (triangles.size() < count) {
    const std::size_t done = triangles.size(), more = std::min(kBlock, count - done);
    triangles.resize(done + more);
    data.read(&triangles[done], more * sizeof triangles[0]);
    for (std::size_t i = done; i < done + more; ++i)
      for (const std::uint32_t corner : triangles[i])
        if (corner >= mesh_.positions.size())
          fail("triangle " + std::to_string(i) + ": a corner is not one of the " +
               std::to_string(mesh_.positions.size()) + " vertices");
  }
}

}  // namespace

Mesh parseSerialized(std::string_view bytes, const std::string& path, int index) {
  const auto part = [bytes](std::size_t offset, std::size_t count) {
    return std::string(bytes.substr(offset, count));
  };
  return SerializedReader(path).read(readSerializedMesh({bytes.size(), part}, path, index));
}

Mesh loadSerialized(const std::string& path, int index) {
  const std::size_t size = plainFileSize(path);
  if (size > kMaxMeshBytes)
    throw SceneError(path + ": has more than " + std::to_string(kMaxMeshBytes) + " bytes");
  const auto part = [&path](std::size_t offset, std::size_t bytes) { return readPart(path, offset, bytes); };
  return SerializedReader(path).read(readSerializedMesh({size, part}, path, index));
}

}  // namespace saccade
