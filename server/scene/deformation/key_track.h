// Keys of one property over time [glTF 2.0, 3.11, appendix C].
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace saccade {

enum class KeyInterpolation { kLinear, kStep, kCubic };

struct KeyTrack {
  KeyInterpolation interpolation = KeyInterpolation::kLinear;
  bool rotates = false;       // values are quaternions x y z w of any length, and linear is along an arc
  std::size_t size = 3;       // numbers of a value
  std::vector<float> times;   // seconds, increasing; at least one
  std::vector<float> values;  // of cubic keys: the in-tangent, the value and the out-tangent

  // Sets `value`, which has `size` numbers. Held before the first key and after the last.
  void at(double seconds, std::span<double> value) const;
};

}  // namespace saccade
