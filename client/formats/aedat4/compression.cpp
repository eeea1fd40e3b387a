#include "client/formats/aedat4/compression.h"

#include <lz4frame.h>

#include <stdexcept>

#include "client/formats/common/expand.h"

namespace saccade::client::aedat4 {
namespace {

// As dv-processing has it in io/compression/compression_support.hpp: blocks of 64 KiB that refer to the ones
// before, no checksum.
LZ4F_preferences_t preferences() {
  LZ4F_preferences_t preferences = LZ4F_INIT_PREFERENCES;
  preferences.frameInfo.blockSizeID = LZ4F_max64KB;
  preferences.frameInfo.blockMode = LZ4F_blockLinked;
  return preferences;
}

std::size_t checked(std::size_t result) {
  if (LZ4F_isError(result)) throw std::runtime_error(LZ4F_getErrorName(result));
  return result;
}

}  // namespace

std::string nameOf(Compression compression) {
  switch (compression) {
    case Compression::kNone:
      return "NONE";
    case Compression::kLz4:
      return "LZ4";
    case Compression::kLz4High:
      return "LZ4_HIGH";
    case Compression::kZstd:
      return "ZSTD";
    case Compression::kZstdHigh:
      return "ZSTD_HIGH";
  }
  return "";
}

void Compressor::Free::operator()(LZ4F_cctx_s* context) const {
  LZ4F_freeCompressionContext(context);
}

Compressor::Compressor(Compression compression) {
  if (compression == Compression::kNone) return;
  LZ4F_cctx* context = nullptr;
  checked(LZ4F_createCompressionContext(&context, LZ4F_VERSION));
  lz4_.reset(context);
}

void Compressor::append(std::string& to, std::string_view bytes) {
  if (!lz4_) {
    to.append(bytes);
    return;
  }
  const LZ4F_preferences_t form = preferences();
  std::size_t size = to.size();
  to.resize(size + LZ4F_HEADER_SIZE_MAX + LZ4F_compressBound(bytes.size(), &form));
  const auto room = [&] { return to.size() - size; };
  size += checked(LZ4F_compressBegin(lz4_.get(), to.data() + size, room(), &form));
  size +=
      checked(LZ4F_compressUpdate(lz4_.get(), to.data() + size, room(), bytes.data(), bytes.size(), nullptr));
  size += checked(LZ4F_compressEnd(lz4_.get(), to.data() + size, room(), nullptr));
  to.resize(size);
}

void expand(std::string& to, std::string_view bytes, Compression compression, std::size_t most) {
  switch (compression) {
    case Compression::kNone:
      to.assign(bytes);
      return;
    case Compression::kLz4:
    case Compression::kLz4High:
      return expandLz4(to, bytes, most);
    case Compression::kZstd:
    case Compression::kZstdHigh:
      return expandZstd(to, bytes, most);
  }
}

}  // namespace saccade::client::aedat4
