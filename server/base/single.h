#pragma once

namespace saccade {

// `v` as a float, where braces would refuse to narrow it.
inline float single(double v) {
  return static_cast<float>(v);
}

}  // namespace saccade
