#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <utility>

#include "scene/mesh_io.h"
#include "scene/ply_header.h"
#include "scene/scene_error.h"
#include "scene/text.h"

namespace saccade {
namespace {

class PlyReader {
 public:
  explicit PlyReader(const std::string& path) : path_(path) {}
  Mesh read();

 private:
  void readVertices(const PlyElement& element);
  void readFaces(const PlyElement& element);
  void readPast(const PlyElement& element);
  void readFace(long long face, const PlyProperty& property);
  void readPast(const PlyProperty& property);
  double readNumber(PlyType type);
  long long readCount(PlyType type);
  double readBinary(PlyType type);
  [[noreturn]] void fail(const std::string& what) const { throw SceneError(path_ + ": " + what); }

  const std::string& path_;
  std::string_view rest_;
  PlyFormat format_{};
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

bool isFaceList(const PlyProperty& p) {
  return p.is_list && !p.type.is_float && (p.name == "vertex_indices" || p.name == "vertex_index");
}

Mesh PlyReader::read() {
  const std::string bytes = readFile(path_);
  rest_ = bytes;
  const PlyHeader header = takePlyHeader(rest_, path_);
  format_ = header.format;
  for (const PlyElement& element : header.elements) {
    if (element.properties.empty()) fail("element '" + element.name + "' has no properties");
    if (element.name == "vertex" && mesh_.positions.empty()) {
      readVertices(element);
    } else if (element.name == "face") {
      readFaces(element);
    } else {
      readPast(element);
    }
  }
  if (mesh_.triangles.empty()) fail("the file has no faces");
  mesh_.name = std::filesystem::path(path_).stem().string();
  return std::move(mesh_);
}

void PlyReader::readVertices(const PlyElement& element) {
  unsigned present = 0;
  for (const auto& p : element.properties)
    if (const int slot = slotOf(p.name); slot >= 0 && !p.is_list) present |= 1u << slot;
  if ((present & 7u) != 7u) fail("the vertices lack x, y or z");
  const bool has_normals = (present & 0x38u) == 0x38u, has_uvs = (present & 0xc0u) == 0xc0u;
  for (long long i = 0; i < element.count; ++i) {
    float values[8] = {};
    for (const auto& p : element.properties) {
      const int slot = p.is_list ? -1 : slotOf(p.name);
      if (slot < 0) {
        readPast(p);
        continue;
      }
      values[slot] = static_cast<float>(readNumber(p.type));
      if (!std::isfinite(values[slot]))
        fail("vertex " + std::to_string(i) + ": '" + p.name + "' is not finite");
    }
    mesh_.positions.push_back({values[0], values[1], values[2]});
    if (has_normals) mesh_.normals.push_back({values[3], values[4], values[5]});
    if (has_uvs) mesh_.uvs.push_back({values[6], values[7]});
  }
}

void PlyReader::readFaces(const PlyElement& element) {
  for (long long i = 0; i < element.count; ++i) {
    for (const auto& p : element.properties) {
      if (isFaceList(p)) {
        readFace(i, p);
      } else {
        readPast(p);
      }
    }
  }
}

void PlyReader::readFace(long long face, const PlyProperty& property) {
  const long long corners = readCount(property.count_type);
  if (corners < 3) fail("face " + std::to_string(face) + " has fewer than 3 corners");
  std::uint32_t first = 0, prev = 0;
  for (long long i = 0; i < corners; ++i) {
    const double index = readNumber(property.type);
    if (!(index >= 0 && index < static_cast<double>(mesh_.positions.size())) || index != std::floor(index))
      fail("face " + std::to_string(face) + ": an index is not one of the " +
           std::to_string(mesh_.positions.size()) + " vertices before it");
    const auto vertex = static_cast<std::uint32_t>(index);
    if (i == 0) first = vertex;
    if (i >= 2) mesh_.triangles.push_back({first, prev, vertex});
    prev = vertex;
  }
}

void PlyReader::readPast(const PlyElement& element) {
  for (long long i = 0; i < element.count; ++i)
    for (const auto& p : element.properties) readPast(p);
}

void PlyReader::readPast(const PlyProperty& property) {
  const long long values = property.is_list ? readCount(property.count_type) : 1;
  for (long long i = 0; i < values; ++i) readNumber(property.type);
}

long long PlyReader::readCount(PlyType type) {
  const double count = readNumber(type);
  if (!(count >= 0 && count == std::floor(count))) fail("the length of a list is not a whole number");
  return static_cast<long long>(std::min(count, 1e18));
}

// Every value takes at least a byte, so that a huge count ends at the end of the file.
double PlyReader::readNumber(PlyType type) {
  if (format_ != PlyFormat::kAscii) return readBinary(type);
  const auto word = takeWord(rest_);
  if (word.empty()) fail("the file ends within its data");
  const auto number = parseNumber(word);
  if (!number) fail("'" + std::string(word.substr(0, 40)) + "' is not a finite number");
  return *number;
}

double PlyReader::readBinary(PlyType type) {
  const auto size = static_cast<std::size_t>(type.bytes);
  if (rest_.size() < size) fail("the file ends within its data");
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t at = format_ == PlyFormat::kLittleEndian ? size - 1 - i : i;
    bits = bits << 8 | static_cast<unsigned char>(rest_[at]);
  }
  rest_.remove_prefix(size);
  if (type.is_float)
    return size == 4 ? std::bit_cast<float>(static_cast<std::uint32_t>(bits)) : std::bit_cast<double>(bits);
  if (!type.is_signed) return static_cast<double>(bits);
  const int unused = 64 - 8 * type.bytes;  // shift the sign up and back down
  return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
}

}  // namespace

Mesh loadPly(const std::string& path) {
  return PlyReader(path).read();
}

}  // namespace saccade
