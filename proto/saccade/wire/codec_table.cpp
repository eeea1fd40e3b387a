#include "saccade/wire/codec_table.h"

namespace saccade {

const std::vector<const CodecInfo*>& codecTable() {
  static const std::vector<const CodecInfo*> table{&kCodecNone, &kCodecZstd};
  return table;
}

const CodecInfo* findCodec(v1::Codec id) {
  for (const CodecInfo* codec : codecTable()) {
    if (codec->id == id) return codec;
  }
  return nullptr;
}

}  // namespace saccade
