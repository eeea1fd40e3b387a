// Which field of a line of poses is which number, as a heading names it.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace saccade {

struct PoseColumns {
  static constexpr std::size_t kValues = 8;  // t x y z qx qy qz qw, in this order
  static constexpr std::size_t kMost = 64;   // fields of a line

  std::array<std::size_t, kValues> at{0, 1, 2, 3, 4, 5, 6, 7};  // field of each value
  std::size_t fields = kValues;
  double time_unit = 0;  // nanoseconds; 0: the heading names none

  bool operator==(const PoseColumns&) const = default;
};

// Whether a line that begins with '#' is a heading and no remark. It names a part of the quaternion, or it
// begins with the time and has at least eight words. Text before a colon does not count.
bool namesColumns(std::string_view comment);

// Reads names such as `#timestamp [ns],p_RS_R_x [m],...,q_RS_w [],...`, between commas or blanks. Throws
// SceneError, without a place, at a name or unit that is not understood, and at a name that is missing or
// there twice. In a comment, other words may follow when all values are named.
PoseColumns readColumns(std::string_view heading);

}  // namespace saccade
