// A plane as bytes for the wire.
#pragma once

#include <bit>
#include <cstring>
#include <string>
#include <string_view>

#include "base/tile_pool.h"
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

// Reads what appendPlane() wrote of a plane of this size.
template <class T>
void readPlane(std::string_view bytes, Image<T>& plane) {
  SACCADE_CHECK(bytes.size() == sizeof(T) * plane.width() * plane.height());
  const std::size_t row = plane.width() * sizeof(T);
  for (int y = 0; y < plane.height(); ++y) std::memcpy(plane.row(y), bytes.data() + y * row, row);
}

// Appends value(x, y) of each pixel, in the same order. Lets urgent pieces of a pool in after each row.
void appendPixels(int width, int height, std::string& bytes, const auto& value) {
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto v = value(x, y);
      bytes.append(reinterpret_cast<const char*>(&v), sizeof v);
    }
    TilePool::yieldToHighPriority();
  }
}

}  // namespace saccade
