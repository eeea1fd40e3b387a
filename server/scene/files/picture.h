// Reads pictures and makes them linear.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/vec.h"

namespace saccade {

struct Picture {
  int width = 0, height = 0;
  std::vector<Rgb> pixels;  // linear; row 0 on top
};

enum class PixelUse {
  kReflectance,     // sRGB-encoded 8/16-bit pictures are made linear; clamped to [0, 1]
  kRawReflectance,  // values are linear already; clamped to [0, 1]
  kOpacity,         // the alpha of a picture that is not opaque all over; of any other, as kReflectance
  kRawOpacity,      // likewise, as kRawReflectance
  kRadiance,        // sRGB-encoded 8/16-bit pictures are made linear; clamped to [0, kMaxRadiance]
};

// Reads a picture with OpenImageIO: its first three channels, or its first as grey; alpha is ignored, but for
// opacity. NaN becomes 0. Throws SceneError if it cannot be read or is larger than limits.h allows.
Picture loadPicture(const std::string& path, PixelUse use);
// The number of pixels, by the header of the file, before memory is taken for them. Throws as loadPicture().
std::size_t countPixels(const std::string& path);

}  // namespace saccade
