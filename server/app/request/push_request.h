// A request that sends a frame, read without a copy of the frame: a frame that must be refused costs no
// memory.
#pragma once

#include <string>
#include <string_view>

namespace saccade {

struct PushRequest {
  std::string stream_id, token;
  std::string_view intensity;  // part of the bytes that were read
};

// Of a serialized v1::Request with push_frame. Throws Refusal.
PushRequest readPush(std::string_view request);

}  // namespace saccade
