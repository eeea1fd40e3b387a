#include "client/recording/digest.h"

#include <array>

namespace saccade::client {
namespace {

template <std::size_t kBytes>
std::string hexOf(const std::array<unsigned char, kBytes>& bytes) {
  std::array<char, 2 * kBytes + 1> text;
  return sodium_bin2hex(text.data(), text.size(), bytes.data(), bytes.size());
}

}  // namespace

std::string Digest::hex() {
  std::array<unsigned char, crypto_generichash_BYTES> bytes;
  crypto_generichash_final(&state_, bytes.data(), bytes.size());
  return hexOf(bytes);
}

std::string sha256Of(std::string_view bytes) {
  std::array<unsigned char, crypto_hash_sha256_BYTES> hash;
  crypto_hash_sha256(hash.data(), reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  return hexOf(hash);
}

}  // namespace saccade::client
