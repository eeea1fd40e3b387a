#include "client/formats/aedat4/compression.h"

#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <new>
#include <stdexcept>

namespace saccade::client::aedat4 {
namespace {

constexpr std::size_t kBlock = 64 << 10;  // bytes

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

// Lets `fill(to, room)` append up to `room` bytes and return their number, until it returns 0.
template <class Fill>
void appendParts(std::string& to, std::size_t most, const Fill& fill) {
  std::size_t size = 0;
  do {
    if (size > most) throw std::runtime_error("more than " + std::to_string(most) + " bytes");
    to.resize(std::max(2 * size, kBlock));
    const std::size_t part = fill(to.data() + size, to.size() - size);
    if (part == 0) break;
    size += part;
  } while (true);
  to.resize(size);
}

void expandLz4(std::string& to, std::string_view bytes, std::size_t most) {
  LZ4F_dctx* made = nullptr;
  checked(LZ4F_createDecompressionContext(&made, LZ4F_VERSION));
  const std::unique_ptr<LZ4F_dctx, LZ4F_errorCode_t (*)(LZ4F_dctx*)> context(made,
                                                                             LZ4F_freeDecompressionContext);
  std::size_t wanted = 1;
  appendParts(to, most, [&](char* at, std::size_t room) {
    if (wanted == 0) return std::size_t{0};
    std::size_t taken = bytes.size();
    wanted = checked(LZ4F_decompress(context.get(), at, &room, bytes.data(), &taken, nullptr));
    bytes.remove_prefix(taken);
    return room;
  });
  if (wanted != 0 || !bytes.empty()) throw std::runtime_error("not one whole LZ4 frame");
}

void expandZstd(std::string& to, std::string_view bytes, std::size_t most) {
  const std::unique_ptr<ZSTD_DStream, std::size_t (*)(ZSTD_DStream*)> context(ZSTD_createDStream(),
                                                                              ZSTD_freeDStream);
  if (!context) throw std::bad_alloc();
  ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
  std::size_t wanted = 1;
  appendParts(to, most, [&](char* at, std::size_t room) {
    ZSTD_outBuffer out{at, room, 0};
    while (wanted != 0 && out.pos < out.size) {
      const std::size_t before = in.pos + out.pos;
      wanted = ZSTD_decompressStream(context.get(), &out, &in);
      if (ZSTD_isError(wanted)) throw std::runtime_error(ZSTD_getErrorName(wanted));
      if (in.pos + out.pos == before) break;
    }
    return out.pos;
  });
  if (wanted != 0 || in.pos < in.size) throw std::runtime_error("not one whole zstd frame");
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
