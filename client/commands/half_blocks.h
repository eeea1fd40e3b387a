// Draws a picture with the letters of a terminal, two pixels in each, in 24-bit colour.
#pragma once

#include <string>

#include "client/drawing/rgb_picture.h"

namespace saccade::client {

// Lines of upper half blocks from the top left of the screen on, without a line feed after the last. The
// letter's colour is the upper pixel, its background the lower one; a missing last row is black.
std::string halfBlocks(const RgbPicture& picture);

}  // namespace saccade::client
