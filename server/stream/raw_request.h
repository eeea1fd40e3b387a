// A request as it came. Only its head is known: what parsing the rest would make is not bounded yet.
#pragma once

#include <cstdint>
#include <string>

#include "saccade/v1/control.pb.h"

namespace saccade {

struct RawRequest {
  std::uint64_t id = 0;
  std::uint32_t version = 0;
  v1::Request::CallCase call = v1::Request::CALL_NOT_SET;
  std::string bytes;
};

// Bytes of a request that opens no stream: such a request is parsed on the control thread.
inline constexpr std::size_t kMaxShortRequest = 4 << 10;

// Reads the head of `raw.bytes` into the other members, in a time that does not depend on their size. Returns
// why the request cannot be handed on, or OK.
v1::Status readHead(RawRequest& raw);

}  // namespace saccade
