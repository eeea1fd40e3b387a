// The digest of bytes that come one after the other.
#pragma once

#include <sodium.h>

#include <string>
#include <string_view>

namespace saccade::client {

// BLAKE2b of 32 bytes.
class Digest {
 public:
  Digest() { crypto_generichash_init(&state_, nullptr, 0, crypto_generichash_BYTES); }
  void add(std::string_view bytes) {
    crypto_generichash_update(&state_, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  }
  std::string hex();  // the last call; hexadecimal

 private:
  crypto_generichash_state state_;
};

std::string sha256Of(std::string_view bytes);  // hexadecimal

}  // namespace saccade::client
