// Polarities of files that others write.
#pragma once

#include <cstdint>
#include <optional>

namespace saccade::client {

// Takes 0 and 1 of a file, or -1 and 1, but not 0 and -1 both. -1 may stand there as 4294967295.
class PolarityScale {
 public:
  // 1 ON, 0 OFF; nullopt: `value` is neither.
  std::optional<std::uint8_t> parse(std::int64_t value) {
    if (value == 1) return 1;
    if (value == 0 && !minus_seen_) return zero_seen_ = true, 0;
    if ((value == -1 || value == UINT32_MAX) && !zero_seen_) return minus_seen_ = true, 0;
    return std::nullopt;
  }

 private:
  bool zero_seen_ = false, minus_seen_ = false;
};

inline constexpr const char* kPolarities = "p is 0 or 1, or -1 and 1 in all of the file";

}  // namespace saccade::client
