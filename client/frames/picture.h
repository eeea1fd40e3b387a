// The light of one picture.
#pragma once

#include <optional>
#include <string>

#include "client/frames/frame_source.h"

namespace saccade::client {

struct Picture {
  int width, height;
  IntensityFrame light;
};

// Whether it may be a picture, by the extension or the beginning. A video is none.
bool isPicture(const std::string& file);

// Throws std::runtime_error that names the file: it cannot be read, holds several pictures, or is larger than
// a frame may be. The header of the file tells the size before pixels are read.
Picture readPicture(const std::string& file, std::optional<Transfer> transfer);

// How to get the frames of a video.
std::string videoAdvice(const std::string& file);

}  // namespace saccade::client
