// Keys of one property of a node over time [glTF 2.0, 3.11, appendix C].
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace saccade {

enum class KeyInterpolation { kLinear, kStep, kCubic };

struct KeyTrack {
  KeyInterpolation interpolation = KeyInterpolation::kLinear;
  std::size_t size = 3;       // numbers of a value: 4 of a rotation, which is a quaternion x y z w
  std::vector<float> times;   // seconds, increasing; at least one
  std::vector<float> values;  // of cubic keys: the in-tangent, the value and the out-tangent

  // Held before the first key and after the last. Quaternions have any length.
  std::array<double, 4> at(double seconds) const;
};

}  // namespace saccade
