// The codecs, which compress payloads: each has a row here and a file in codecs/.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "saccade/v1/events.pb.h"

namespace saccade {

struct CodecInfo {
  v1::Codec id;
  const char* name;
  std::string (*encode)(std::string raw);
  // Nothing where `coded` does not decode to exactly `raw_size` bytes.
  std::optional<std::string> (*decode)(std::string coded, std::size_t raw_size);
};

extern const CodecInfo kCodecNone, kCodecZstd;

// THE list of codecs.
const std::vector<const CodecInfo*>& codecTable();
const CodecInfo* findCodec(v1::Codec id);  // nullptr if this build does not know it

}  // namespace saccade
