// The version of the protocol.
#pragma once

#include <cstdint>

namespace saccade {

inline constexpr std::uint32_t kProtocolVersion = 1;  // Request.protocol_version

}  // namespace saccade
