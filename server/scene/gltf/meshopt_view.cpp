#include "scene/gltf/meshopt_view.h"

#include <meshoptimizer.h>

#include "scene/files/limits.h"

namespace saccade {
namespace {

constexpr std::size_t kMaxStride = 256;  // bytes

// One of what the extension allows for `mode` and `filter`.
[[noreturn]] void refuse(const JsonNode& coded, const std::string& what) {
  throw coded.error("the " + what + " is not one of EXT_meshopt_compression for this byteStride");
}

// Returns 0 where the bytes are sound.
int decodeAs(const std::string& mode, const JsonNode& coded, std::size_t count, std::size_t stride,
             std::string_view bytes, char* to) {
  const auto* from = reinterpret_cast<const unsigned char*>(bytes.data());
  const bool indices = (stride == 2 || stride == 4);
  if (mode == "ATTRIBUTES" && stride > 0 && stride % 4 == 0)
    return meshopt_decodeVertexBuffer(to, count, stride, from, bytes.size());
  if (mode == "TRIANGLES" && indices && count % 3 == 0)
    return meshopt_decodeIndexBuffer(to, count, stride, from, bytes.size());
  if (mode == "INDICES" && indices) return meshopt_decodeIndexSequence(to, count, stride, from, bytes.size());
  refuse(coded, "mode");
}

void filterAs(const std::string& filter, const JsonNode& coded, std::size_t count, std::size_t stride,
              char* bytes) {
  if (filter == "NONE") return;
  if (filter == "OCTAHEDRAL" && (stride == 4 || stride == 8))
    meshopt_decodeFilterOct(bytes, count, stride);
  else if (filter == "QUATERNION" && stride == 8)
    meshopt_decodeFilterQuat(bytes, count, stride);
  else if (filter == "EXPONENTIAL" && stride % 4 == 0)
    meshopt_decodeFilterExp(bytes, count, stride);
  else
    refuse(coded, "filter");
}

}  // namespace

std::size_t decodedBytes(const JsonNode& coded) {
  const std::size_t count = coded.at("count").size(), stride = coded.at("byteStride").size();
  if (stride > kMaxStride || count > kMaxMeshBytes / kMaxStride) throw coded.error("holds too many elements");
  return count * stride;
}

std::string decodeMeshopt(const JsonNode& coded, std::string_view bytes) {
  const std::size_t count = coded.at("count").size(), stride = coded.at("byteStride").size();
  std::string decoded(count * stride, '\0');
  const std::string mode = coded.at("mode").text();
  if (decodeAs(mode, coded, count, stride, bytes, decoded.data()) != 0)
    throw coded.error("its bytes are damaged");
  filterAs(coded.text("filter", "NONE"), coded, count, stride, decoded.data());
  return decoded;
}

}  // namespace saccade
