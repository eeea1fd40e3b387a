// A plane as bytes for the wire.
#pragma once

#include <bit>
#include <string>

#include "frame/image.h"

namespace saccade {

static_assert(std::endian::native == std::endian::little, "planes are copied as they lie in memory");

// Appends width * height values, row by row from the top, without the border.
template <class T>
void appendPlane(const Image<T>& plane, std::string& bytes) {
  for (int y = 0; y < plane.height(); ++y) {
    bytes.append(reinterpret_cast<const char*>(plane.row(y)), plane.width() * sizeof(T));
  }
}

}  // namespace saccade
