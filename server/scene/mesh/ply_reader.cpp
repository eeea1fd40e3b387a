#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/files/limits.h"
#include "scene/files/plain_file.h"
#include "scene/files/scene_error.h"
#include "scene/mesh/mesh_io.h"
#include "scene/mesh/ply_header.h"
#include "scene/mesh/ply_values.h"

namespace saccade {
namespace {

class PlyReader {
 public:
  explicit PlyReader(const std::string& path) : path_(path) {}
  Mesh read(std::string_view bytes);

 private:
  void readVertices(const PlyElement& element, PlyValues& values);
  void readFaces(const PlyElement& element, PlyValues& values);
  void readFace(long long face, const PlyProperty& property, PlyValues& values);
  [[noreturn]] void fail(const std::string& what) const { throw SceneError(path_ + ": " + what); }

  const std::string& path_;
  Mesh mesh_;
};

// Where a vertex property goes: an index into {x y z nx ny nz u v}, or none.
int slotOf(const std::string& name) {
  static constexpr std::pair<std::string_view, int> kSlots[] = {
      {"x", 0}, {"y", 1}, {"z", 2}, {"nx", 3}, {"ny", 4}, {"nz", 5}, {"u", 6}, {"v", 7}, {"s", 6}, {"t", 7}};
  for (const auto& [known, slot] : kSlots)
    if (known == name) return slot;
  return -1;
}

bool isColour(const PlyProperty& p) {
  return p.name == "red" || p.name == "diffuse_red";
}

bool isFaceList(const PlyProperty& p) {
  return p.is_list && !p.type.is_float && (p.name == "vertex_indices" || p.name == "vertex_index");
}

Mesh PlyReader::read(std::string_view bytes) {
  const PlyHeader header = takePlyHeader(bytes, path_);
  PlyValues values(bytes, header.format, path_);
  for (const PlyElement& element : header.elements) {
    if (std::ranges::any_of(element.properties, isColour))
      mesh_.unread = path_ + ": its colours are not read; the shape is grey without a <bsdf>";
    if (element.properties.empty()) fail("element '" + element.name + "' has no properties");
    if (element.name == "vertex" && mesh_.positions.empty()) {
      readVertices(element, values);
    } else if (element.name == "face") {
      readFaces(element, values);
    } else {
      for (long long i = 0; i < element.count; ++i)
        for (const auto& p : element.properties) values.ignore(p);
    }
  }
  if (mesh_.triangles.empty()) fail("the file has no faces");
  return std::move(mesh_);
}

void PlyReader::readVertices(const PlyElement& element, PlyValues& values) {
  unsigned present = 0;
  for (const auto& p : element.properties)
    if (const int slot = slotOf(p.name); slot >= 0 && !p.is_list) present |= 1u << slot;
  if ((present & 7u) != 7u) fail("the vertices lack x, y or z");
  const bool has_normals = (present & 0x38u) == 0x38u, has_uvs = (present & 0xc0u) == 0xc0u;
  for (long long i = 0; i < element.count; ++i) {
    float v[8] = {};
    for (const auto& p : element.properties) {
      const int slot = p.is_list ? -1 : slotOf(p.name);
      if (slot < 0) {
        values.ignore(p);
        continue;
      }
      v[slot] = static_cast<float>(values.readNumber(p.type));
      if (!std::isfinite(v[slot])) fail("vertex " + std::to_string(i) + ": '" + p.name + "' is not finite");
    }
    mesh_.positions.push_back({v[0], v[1], v[2]});
    if (has_normals) mesh_.normals.push_back({v[3], v[4], v[5]});
    if (has_uvs) mesh_.uvs.push_back({v[6], v[7]});
  }
}

void PlyReader::readFaces(const PlyElement& element, PlyValues& values) {
  for (long long i = 0; i < element.count; ++i) {
    for (const auto& p : element.properties) {
      if (isFaceList(p)) {
        readFace(i, p, values);
      } else {
        values.ignore(p);
      }
    }
  }
}

void PlyReader::readFace(long long face, const PlyProperty& property, PlyValues& values) {
  const long long corners = values.readCount(property.count_type);
  if (corners < 3) fail("face " + std::to_string(face) + " has fewer than 3 corners");
  if (static_cast<std::size_t>(corners) + mesh_.triangles.size() > kMaxTriangles)
    fail("more than " + std::to_string(kMaxTriangles) + " triangles");
  std::uint32_t first = 0, prev = 0;
  for (long long i = 0; i < corners; ++i) {
    const double index = values.readNumber(property.type);
    if (!(index >= 0 && index < static_cast<double>(mesh_.positions.size())) || index != std::floor(index))
      fail("face " + std::to_string(face) + ": an index is not one of the " +
           std::to_string(mesh_.positions.size()) + " vertices before it");
    const auto vertex = static_cast<std::uint32_t>(index);
    if (i == 0) first = vertex;
    if (i >= 2) mesh_.triangles.push_back({first, prev, vertex});
    prev = vertex;
  }
}

}  // namespace

Mesh parsePly(std::string_view bytes, const std::string& path) {
  return PlyReader(path).read(bytes);
}

Mesh loadPly(const std::string& path) {
  return parsePly(readFile(path, kMaxMeshBytes), path);
}

}  // namespace saccade
