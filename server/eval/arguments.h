// Sizes and ranges of frames, as the flags of saccade-eval say them.
#pragma once

#include <string>

namespace saccade {

struct Size {
  int width = 256, height = 256;
};
// "WxH", 1 to 16384 each. Throws CLI::ValidationError, a std::runtime_error.
Size parseSize(const std::string& text);

struct FrameRange {
  int first = 1, last = 21;
};
// "A:B", frames A to B with 1 <= A <= B <= 1,000,000 (the change of frame 1 is since frame 0), or one frame.
// Throws as well.
FrameRange parseFrameRange(const std::string& text);

}  // namespace saccade
