// What both ends agree on before the first byte.
#pragma once

#include <cstdint>

namespace saccade {

inline constexpr std::uint32_t kProtocolVersion = 1;  // Request.protocol_version

}  // namespace saccade
