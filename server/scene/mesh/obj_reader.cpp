#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "base/hash_rng.h"
#include "scene/files/limits.h"
#include "scene/files/plain_file.h"
#include "scene/files/scene_error.h"
#include "scene/files/text.h"
#include "scene/mesh/mesh_io.h"

namespace saccade {
namespace {

struct Corner {
  std::uint32_t v, vt, vn;  // kNone where the file gives none
  friend bool operator==(const Corner&, const Corner&) = default;
};
constexpr std::uint32_t kNone = 0xffffffffu;

struct CornerHash {
  std::size_t operator()(const Corner& c) const { return hashKey(hashKey(c.v, c.vt), c.vn); }
};

class ObjReader {
 public:
  explicit ObjReader(const std::string& path) : path_(path) {}
  ObjFile read(std::string_view text);

 private:
  void readLine(std::string_view line);
  template <int N>
  std::array<float, N> readNumbers(std::string_view words) const;
  void readFace(std::string_view words);
  Corner readCorner(std::string_view word) const;
  std::uint32_t resolve(std::string_view index, std::size_t count, const char* what) const;
  std::uint32_t vertexOf(const Corner& corner);
  [[noreturn]] void fail(const std::string& what) const { throw SceneError(path_, line_, what); }

  const std::string& path_;
  long line_ = 0;
  std::vector<Vec3> v_, vn_;
  std::vector<Vec2> vt_;
  std::unordered_map<Corner, std::uint32_t, CornerHash> vertices_;
  std::vector<std::uint32_t> face_;
  bool all_uvs_ = true, all_normals_ = true;
  ObjFile file_;
  Mesh& mesh_ = file_.mesh;
};

ObjFile ObjReader::read(std::string_view text) {
  while (!text.empty()) {
    ++line_;
    readLine(takeLine(text));
  }
  if (mesh_.triangles.empty()) fail("the file has no faces");
  if (!all_uvs_) mesh_.uvs.clear();
  if (!all_normals_) mesh_.normals.clear();
  return std::move(file_);
}

void ObjReader::readLine(std::string_view line) {
  const std::string_view keyword = takeWord(line);
  if (keyword == "v") {
    const auto [x, y, z] = readNumbers<3>(line);
    v_.push_back({x, y, z});
  } else if (keyword == "vn") {
    const auto [x, y, z] = readNumbers<3>(line);
    vn_.push_back({x, y, z});
  } else if (keyword == "vt") {
    const auto [u, v] = readNumbers<2>(line);
    vt_.push_back({u, v});
  } else if (keyword == "f") {
    readFace(line);
  } else if (keyword == "usemtl") {
    file_.uses.push_back({mesh_.triangles.size(), std::string(trimmed(line))});
  } else if (keyword == "mtllib") {
    file_.libraries.emplace_back(trimmed(line));
  }
}

// Values after the first N, such as a weight or a colour, are ignored.
template <int N>
std::array<float, N> ObjReader::readNumbers(std::string_view words) const {
  std::array<float, N> values;
  for (float& value : values) {
    const std::string_view word = takeWord(words);
    const auto number = parseNumber(word);
    value = static_cast<float>(number.value_or(INFINITY));
    if (!std::isfinite(value))
      fail("expected " + std::to_string(N) + " finite numbers, found '" + std::string(word) + "'");
  }
  return values;
}

void ObjReader::readFace(std::string_view words) {
  face_.clear();
  for (auto word = takeWord(words); !word.empty() && word[0] != '#'; word = takeWord(words))
    face_.push_back(vertexOf(readCorner(word)));
  if (face_.empty()) fail("a face needs corners");
  if (mesh_.triangles.size() + face_.size() > kMaxTriangles)
    fail("more than " + std::to_string(kMaxTriangles) + " triangles");
  for (std::size_t i = 2; i < face_.size(); ++i)
    mesh_.triangles.push_back({face_[0], face_[i - 1], face_[i]});
}

Corner ObjReader::readCorner(std::string_view word) const {
  std::array<std::string_view, 3> parts;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t slash = std::min(word.find('/'), word.size());
    parts[i] = word.substr(0, slash);
    word.remove_prefix(std::min(slash + 1, word.size()));
  }
  if (!word.empty()) fail("a corner has at most v/vt/vn");
  return {resolve(parts[0], v_.size(), "vertex"),
          parts[1].empty() ? kNone : resolve(parts[1], vt_.size(), "texture coordinate"),
          parts[2].empty() ? kNone : resolve(parts[2], vn_.size(), "normal")};
}

std::uint32_t ObjReader::resolve(std::string_view index, std::size_t count, const char* what) const {
  const auto given = parseInteger(index);
  const long long size = static_cast<long long>(count);
  const long long i = !given ? -1 : *given < 0 ? size + *given : *given - 1;
  if (i < 0 || i >= size)
    fail(std::string(what) + " index '" + std::string(index) + "' is not one of the " + std::to_string(size) +
         " given so far");
  return static_cast<std::uint32_t>(i);
}

std::uint32_t ObjReader::vertexOf(const Corner& corner) {
  const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
  const auto [found, added] = vertices_.try_emplace(corner, next);
  if (!added) return found->second;
  all_uvs_ &= corner.vt != kNone;
  all_normals_ &= corner.vn != kNone;
  mesh_.positions.push_back(v_[corner.v]);
  mesh_.uvs.push_back(corner.vt == kNone ? Vec2{} : vt_[corner.vt]);
  mesh_.normals.push_back(corner.vn == kNone ? Vec3{} : vn_[corner.vn]);
  return next;
}

}  // namespace

ObjFile loadObjFile(const std::string& path) {
  return ObjReader(path).read(readFile(path, kMaxMeshBytes));
}

Mesh parseObj(std::string_view bytes, const std::string& path) {
  ObjFile file = ObjReader(path).read(bytes);
  if (!file.uses.empty())
    file.mesh.unread = path + ": its materials (usemtl) are not read; the shape is grey without a <bsdf>";
  return std::move(file.mesh);
}

Mesh loadObj(const std::string& path) {
  return parseObj(readFile(path, kMaxMeshBytes), path);
}

}  // namespace saccade
