#include "client/recording/event_digest.h"
#include "client/formats/common/units.h"

#include <cstring>

namespace saccade::client {
namespace {

constexpr std::size_t kEventBytes = 13;  // s64 us | u16 x | u16 y | u8 p, as recording.proto says

}  // namespace

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
  digest_.add(bytes_);
}

}  // namespace saccade::client
