// Makes the Status of a reply.
#pragma once

#include <string>

#include "saccade/v1/control.pb.h"

namespace saccade {

inline constexpr const char* kNoRequest = "a request is one part: a serialized saccade.v1.Request";

v1::Status okStatus();
v1::Status makeStatus(v1::Code code, const std::string& message, const std::string& field = {});
v1::Status noMemoryStatus();  // of std::bad_alloc

}  // namespace saccade
