#include "scene/mesh/serialized_file.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string_view>
#include <vector>

#include "scene/files/scene_error.h"

namespace saccade {
namespace {

static_assert(std::endian::native == std::endian::little, "as the files are");

constexpr std::uint16_t kMagic = 0x041c;
constexpr std::size_t kHeaderBytes = 4;  // of each mesh: magic number and version

// The number at the beginning of `bytes`.
template <class T>
T numberIn(std::string_view bytes) {
  T value;
  std::copy_n(bytes.data(), sizeof value, reinterpret_cast<char*>(&value));
  return value;
}

struct Reader {
  const FileParts& file;
  const std::string& path;

  [[noreturn]] void fail(const std::string& what) const { throw SceneError(path + ": " + what); }

  int readVersion(std::size_t offset) const {
    if (offset > file.size || file.size - offset < kHeaderBytes) fail("the file ends within its header");
    const std::string header = file.read(offset, kHeaderBytes);
    if (numberIn<std::uint16_t>(header) != kMagic) fail("not a serialized mesh of Mitsuba");
    const int version = numberIn<std::uint16_t>(header.substr(2));
    if (version != 3 && version != 4)
      fail("version " + std::to_string(version) + " is not supported; supported: 3, 4");
    return version;
  }

  // Where the meshes begin. Empty: there is no list of it.
  std::vector<std::size_t> readOffsets(int version) const {
    const std::size_t entry = version == 3 ? 4 : 8, tail = sizeof(std::uint32_t);
    const std::size_t count = numberIn<std::uint32_t>(file.read(file.size - tail, tail));
    if (count * (entry + kHeaderBytes) + tail > file.size) return {};
    const std::string list = file.read(file.size - tail - count * entry, count * entry);
    std::vector<std::size_t> offsets;
    for (std::string_view rest = list; !rest.empty(); rest.remove_prefix(entry))
      offsets.push_back(version == 3 ? numberIn<std::uint32_t>(rest) : numberIn<std::uint64_t>(rest));
    return offsets;
  }
};

}  // namespace

SerializedMesh readSerializedMesh(const FileParts& file, const std::string& path, int index) {
  const Reader reader{file, path};
  const std::vector<std::size_t> offsets = reader.readOffsets(reader.readVersion(0));
  const auto i = static_cast<std::size_t>(index);
  const std::size_t count = std::max<std::size_t>(1, offsets.size());
  if (index < 0 || i >= count)
    reader.fail("shape_index " + std::to_string(index) + " is not one of its " + std::to_string(count) +
                " meshes");
  const std::size_t begin = i == 0 ? 0 : offsets[i];
  const std::size_t end = i + 1 < offsets.size() ? offsets[i + 1] : file.size;
  const int version = reader.readVersion(begin);
  if (end > file.size || end < begin + kHeaderBytes) reader.fail("the list of meshes at its end is faulty");
  return {version, file.read(begin + kHeaderBytes, end - begin - kHeaderBytes)};
}

}  // namespace saccade
