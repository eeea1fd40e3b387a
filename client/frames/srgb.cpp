#include <algorithm>
#include <cmath>

#include "client/frames/frame_source.h"

namespace saccade::client {

float linearFromSrgb(float value) {
  if (value <= 0.04045f) return std::max(value, 0.0f) / 12.92f;
  return std::pow((value + 0.055f) / 1.055f, 2.4f);
}

}  // namespace saccade::client
