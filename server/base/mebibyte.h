// The unit of limits on memory.
#pragma once

namespace saccade {

inline constexpr double kMiB = 1 << 20;  // bytes

}  // namespace saccade
