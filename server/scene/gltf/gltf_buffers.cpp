#include "scene/gltf/gltf_buffers.h"

#include <algorithm>

#include "scene/files/limits.h"
#include "scene/gltf/meshopt_view.h"

namespace saccade {
namespace {

constexpr const char* kMeshopt = "EXT_meshopt_compression";

// A buffer without an address is the binary part of a .glb, or holds nothing: what it would hold is
// compressed elsewhere.
std::string readBuffer(const GltfFile& file, const JsonNode& buffer, bool first) {
  const std::size_t count = buffer.at("byteLength").size();
  const auto uri = buffer.find("uri");
  if (uri) return file.readUri(*uri, uri->text(), count);
  return first ? file.readBinary(buffer, count) : std::string();
}

}  // namespace

GltfBuffers::GltfBuffers(const GltfFile& file) : file_(file) {
  for (const JsonNode& buffer : file.root().list("buffers")) {
    take(buffer, buffer.at("byteLength").size(), kMaxMeshBytes);
    buffers_.push_back(readBuffer(file, buffer, buffers_.empty()));
  }
  const std::size_t most = std::min(kMaxMeshBytes, bytes_ * kMaxMeshBytesPerByte);
  std::size_t i = 0;
  for (const JsonNode& view : file.root().list("bufferViews")) {
    if (const auto coded = view.extension(kMeshopt)) {
      take(view, decodedBytes(*coded), most);
      decoded_[i] = decodeMeshopt(*coded, part(*coded));
    }
    ++i;
  }
}

// Before memory is taken.
void GltfBuffers::take(const JsonNode& at, std::size_t count, std::size_t most) {
  if (count > most || bytes_ > most - count)
    throw at.error("the buffers have more than " + std::to_string(most) + " bytes together");
  bytes_ += count;
}

GltfBuffers::View GltfBuffers::view(std::size_t i) const {
  const JsonNode view = file_.root().entry("bufferViews", i);
  const std::size_t stride = view.size("byteStride", 0);
  if (const auto found = decoded_.find(i); found != decoded_.end())
    return {found->second, view.extension(kMeshopt)->at("byteStride").size()};
  return {part(view), stride};
}

// `view`: with buffer, byteOffset and byteLength.
std::string_view GltfBuffers::part(const JsonNode& view) const {
  const std::string_view buffer = buffers_[view.at("buffer").index(buffers_.size())];
  const std::size_t offset = view.size("byteOffset", 0), count = view.at("byteLength").size();
  if (offset > buffer.size() || count > buffer.size() - offset)
    throw view.error("reaches beyond the end of its buffer");
  return buffer.substr(offset, count);
}

}  // namespace saccade
