// Compresses and expands what follows the headers of packets.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

struct LZ4F_cctx_s;

namespace saccade::client::aedat4 {

// The numbers of the format.
enum class Compression : std::int32_t { kNone, kLz4, kLz4High, kZstd, kZstdHigh };

// "LZ4"; "" for a number that the format does not know.
std::string nameOf(Compression compression);

class Compressor {
 public:
  explicit Compressor(Compression compression);  // kNone or kLz4

  void append(std::string& to, std::string_view bytes);

 private:
  struct Free {
    void operator()(LZ4F_cctx_s* context) const;
  };
  std::unique_ptr<LZ4F_cctx_s, Free> lz4_;  // none: kNone
};

// Replaces `to`. Throws std::runtime_error if `bytes` are not of that form, or give more than `most` bytes.
void expand(std::string& to, std::string_view bytes, Compression compression, std::size_t most);

}  // namespace saccade::client::aedat4
