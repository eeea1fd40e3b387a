#include "scene/gltf/gltf_uri.h"

#include <nettle/base64.h>

#include <charconv>

namespace saccade {

std::string decodedPath(const std::string& uri) {
  std::string path;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned char byte = 0;
    const char* digits = uri.data() + i + 1;
    const bool coded = uri[i] == '%' && i + 2 < uri.size() &&
                       std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2 && byte != 0;
    path += coded ? static_cast<char>(byte) : uri[i];
    if (coded) i += 2;
  }
  return path;
}

bool isData(const std::string& uri) {
  return uri.starts_with("data:");
}

std::string decodeData(const JsonNode& at, const std::string& uri) {
  const std::string mark = ";base64,";
  const std::size_t found = uri.substr(0, 256).find(mark);
  if (found == uri.npos) throw at.error("holds data that are not base64");
  const std::size_t begin = found + mark.size(), length = uri.size() - begin;
  std::string bytes(BASE64_DECODE_LENGTH(length), '\0');
  base64_decode_ctx context;
  base64_decode_init(&context);
  std::size_t count = bytes.size();
  const bool good = base64_decode_update(&context, &count, reinterpret_cast<std::uint8_t*>(bytes.data()),
                                         length, uri.data() + begin) &&
                    base64_decode_final(&context);
  if (!good) throw at.error("holds data that are not base64");
  bytes.resize(count);
  return bytes;
}

}  // namespace saccade
