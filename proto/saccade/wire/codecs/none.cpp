// No compression: clients read the columns in place.
#include "saccade/wire/codec_table.h"

namespace saccade {
namespace {

std::string encode(std::string raw) {
  return raw;
}

std::optional<std::string> decode(std::string coded, std::size_t raw_size) {
  if (coded.size() != raw_size) return std::nullopt;
  return coded;
}

}  // namespace

const CodecInfo kCodecNone{v1::CODEC_NONE, "none", encode, decode};

}  // namespace saccade
