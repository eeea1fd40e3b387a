// Reads pictures and makes them linear.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec.h"

namespace saccade {

struct Picture {
  int width = 0, height = 0;
  std::vector<Rgb> pixels;  // linear; row 0 on top
};

// A file, or the bytes of one within another. These must outlive it.
struct PictureFile {
  PictureFile(std::string path) : name(std::move(path)) {}
  PictureFile(std::string_view bytes_, std::string name_) : name(std::move(name_)), bytes(bytes_) {}

  std::string name;  // the path; of bytes, for messages
  std::optional<std::string_view> bytes = {};
};

enum class PixelUse {
  kReflectance,     // sRGB-encoded 8/16-bit pictures are made linear; clamped to [0, 1]
  kRawReflectance,  // values are linear already; clamped to [0, 1]
  kOpacity,         // the alpha of a picture that is not opaque all over; of any other, as kReflectance
  kRawOpacity,      // likewise, as kRawReflectance
  kAlpha,           // the alpha; 1 where the picture has none
  kRadiance,        // sRGB-encoded 8/16-bit pictures are made linear; clamped to [0, kMaxRadiance]
  kRawRadiance,     // values are linear already; clamped likewise
};

// Reads a picture with OpenImageIO: its first three channels, or its first as grey; alpha is ignored, but for
// opacity. NaN becomes 0. Throws SceneError if it cannot be read or is larger than limits.h allows.
Picture loadPicture(const PictureFile& source, PixelUse use);
// The number of pixels, by the header of the file, before memory is taken for them. Throws as loadPicture().
std::size_t countPixels(const PictureFile& source);

}  // namespace saccade
