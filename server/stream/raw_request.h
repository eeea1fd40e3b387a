// A request of which only the head is read: nothing bounds yet what parsing the rest would allocate.
#pragma once

#include <cstdint>

#include "saccade/v1/control.pb.h"
#include "stream/message_part.h"

namespace saccade {

struct RawRequest {
  std::uint64_t id = 0;
  std::uint32_t version = 0;
  v1::Request::CallCase call = v1::Request::CALL_NOT_SET;
  MessagePart message;
};

// Most bytes of any request but open_stream and push_frame, and of steer, which may have objects.
inline constexpr std::size_t kMaxShortRequest = 4 << 10, kMaxSteerRequest = 32 << 10;

// Reads the head of `raw.message` into the other members, in a time that does not depend on their size.
// Returns OK, or why the request must be refused.
v1::Status readHead(RawRequest& raw);

}  // namespace saccade
