#include "client/recording/event_digest.h"
#include "client/formats/common/units.h"

#include <array>
#include <cstring>

namespace saccade::client {
namespace {

constexpr std::size_t kEventBytes = 13;  // s64 us | u16 x | u16 y | u8 p, as recording.proto says

}  // namespace

EventDigest::EventDigest() {
  crypto_generichash_init(&state_, nullptr, 0, crypto_generichash_BYTES);
}

void EventDigest::add(const Events& events) {
  bytes_.resize(events.size() * kEventBytes);
  char* at = bytes_.data();
  for (const Event& event : events) {
    const std::int64_t t_us = event.t_ns / kNsPerUs;
    std::memcpy(at, &t_us, 8);
    std::memcpy(at + 8, &event.x, 2);
    std::memcpy(at + 10, &event.y, 2);
    at[12] = static_cast<char>(event.p);
    at += kEventBytes;
  }
  crypto_generichash_update(&state_, reinterpret_cast<const unsigned char*>(bytes_.data()), bytes_.size());
}

std::string EventDigest::hex() {
  std::array<unsigned char, crypto_generichash_BYTES> digest;
  crypto_generichash_final(&state_, digest.data(), digest.size());
  std::array<char, 2 * crypto_generichash_BYTES + 1> text;
  return sodium_bin2hex(text.data(), text.size(), digest.data(), digest.size());
}

}  // namespace saccade::client
