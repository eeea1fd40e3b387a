// Planes with known values.
#pragma once

#include <initializer_list>

#include "frame/image.h"

namespace saccade::test {

// A plane of one row.
inline ImageF plane(std::initializer_list<float> values) {
  ImageF image(static_cast<int>(values.size()), 1);
  std::copy(values.begin(), values.end(), image.row(0));
  return image;
}

}  // namespace saccade::test
