#include "client/formats/common/expand.h"

#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <memory>
#include <new>
#include <stdexcept>

namespace saccade::client {
namespace {

constexpr std::size_t kBlock = 64 << 10;  // bytes

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

}  // namespace

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

}  // namespace saccade::client
