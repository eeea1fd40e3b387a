// Reads and writes pictures.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "eval/metrics/rgb_planes.h"

namespace saccade::eval {

struct ExrChannel {
  std::string name;
  const ImageF* plane;
};

// Writes 32-bit float OpenEXR, or by the extension .png 8 bits; all planes of one size. Makes the folder. The
// file appears whole or not at all. Throws std::runtime_error.
void writeExr(const std::string& path, const std::vector<ExrChannel>& channels,
              const std::map<std::string, int>& attributes = {});

struct ExrPicture {
  std::map<std::string, ImageF> planes;  // by channel name
  std::map<std::string, int> attributes;
};
// Throws std::runtime_error if the file cannot be read.
ExrPicture readExr(const std::string& path);

// The channels R, G and B. Throws std::runtime_error, also without one of them.
RgbPlanes readRgb(const std::string& path);

struct Rgb8 {
  unsigned char r, g, b;
};
// The bytes of a PNG file; rows from the top. Throws std::runtime_error.
std::string encodePng(int width, int height, const std::vector<Rgb8>& pixels);

}  // namespace saccade::eval
