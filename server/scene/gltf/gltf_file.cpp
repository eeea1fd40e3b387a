#include "scene/gltf/gltf_file.h"

#include <cstring>
#include <filesystem>

#include "base/text_cut.h"
#include "scene/files/confinement.h"
#include "scene/files/find_file.h"
#include "scene/files/limits.h"
#include "scene/files/plain_file.h"
#include "scene/gltf/gltf_extensions.h"
#include "scene/gltf/gltf_uri.h"

namespace saccade {
namespace {

constexpr std::size_t kHeadBytes = 12, kChunkHeadBytes = 8;  // of a .glb [glTF 2.0, 4.4]
constexpr std::uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

std::uint32_t wordAt(const std::string& bytes, std::size_t offset) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + offset, sizeof word);  // little-endian, as the machine
  return word;
}

// A part of a .glb.
struct Chunk {
  std::size_t begin, bytes;
  std::uint32_t type;
};

Chunk chunkAt(const std::string& path, std::size_t offset, std::size_t file_bytes) {
  if (offset + kChunkHeadBytes > file_bytes) throw SceneError(path + ": ends within a part of the .glb");
  const std::string head = readPart(path, offset, kChunkHeadBytes);
  const Chunk chunk{offset + kChunkHeadBytes, wordAt(head, 0), wordAt(head, 4)};
  if (chunk.bytes > file_bytes - chunk.begin) throw SceneError(path + ": ends within a part of the .glb");
  return chunk;
}

void requireSize(const std::string& path, std::size_t bytes) {
  if (bytes > kMaxGltfJsonBytes)
    throw SceneError(path + ": has more than " + std::to_string(kMaxGltfJsonBytes) + " bytes of JSON");
}

}  // namespace

GltfFile::GltfFile(const std::string& path, const LoadOptions& options) : path_(path), options_(options) {
  if (!mayRead(path, options.confined_to)) throw SceneError(path + ": leads out of the folder of the scenes");
  json_ = parseJson(readJson(), path);
  const std::string version = root().at("asset").at("version").text();
  if (!version.starts_with("2."))
    throw root().error("is glTF " + cutText(version, kMaxEcho) + "; only version 2.0 is read");
  requireExtensions(root());
}

std::string GltfFile::readJson() {
  const std::size_t file_bytes = plainFileSize(path_);
  const std::string head = readBeginning(path_, kHeadBytes);
  if (head.size() < kHeadBytes || wordAt(head, 0) != kMagic) {
    requireSize(path_, file_bytes);
    return readFile(path_, kMaxGltfJsonBytes);
  }
  if (wordAt(head, 4) != 2)
    throw SceneError(path_ + ": is a .glb of version " + std::to_string(wordAt(head, 4)) +
                     "; only version 2 is read");
  const Chunk json = chunkAt(path_, kHeadBytes, file_bytes);
  if (json.type != kJsonChunk) throw SceneError(path_ + ": the first part of the .glb is not JSON");
  requireSize(path_, json.bytes);
  const std::size_t next = json.begin + json.bytes;
  if (next < file_bytes) {
    const Chunk binary = chunkAt(path_, next, file_bytes);
    if (binary.type == kBinaryChunk) binary_begin_ = binary.begin, binary_bytes_ = binary.bytes;
  }
  return readPart(path_, json.begin, json.bytes);
}

std::string GltfFile::locate(const JsonNode& at, const std::string& uri) const {
  try {
    return findFile(decodedPath(uri), std::filesystem::path(path_).parent_path(), options_);
  } catch (const SceneError& fault) {
    throw at.error(fault.what());
  }
}

std::string GltfFile::readUri(const JsonNode& at, const std::string& uri, std::size_t count) const {
  std::string bytes;
  if (isData(uri)) {
    bytes = decodeData(at, uri);
  } else {
    const std::string path = locate(at, uri);
    try {
      if (plainFileSize(path) >= count) bytes = readPart(path, 0, count);
    } catch (const SceneError& fault) {
      throw at.error(fault.what());
    }
  }
  if (bytes.size() < count)
    throw at.error(cutText(uri, kMaxEcho) + " has less than " + std::to_string(count) + " bytes");
  bytes.resize(count);
  return bytes;
}

std::string GltfFile::readBinary(const JsonNode& at, std::size_t count) const {
  if (binary_bytes_ == 0) return {};
  if (count > binary_bytes_) throw at.error("the binary part of the .glb is shorter than byteLength");
  return readPart(path_, binary_begin_, count);
}

}  // namespace saccade
