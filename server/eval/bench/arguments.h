// Sizes, ranges of frames and budgets, as the flags of saccade-eval say them. All throw CLI::ValidationError,
// a std::runtime_error, naming the flag and what is valid.
#pragma once

#include <string>

#include "methods/method_spec.h"

namespace saccade::eval {

struct Size {
  int width = 256, height = 256;
};
// "WxH", 1 to 16384 each.
Size parseSize(const std::string& text);

struct FrameRange {
  int first = 1, last = 21;
};
// "A:B", frames A to B with 1 <= A <= B <= 1,000,000 (the change of frame 1 is since frame 0), or one frame.
FrameRange parseFrameRange(const std::string& text);

// "2%", over 0% and up to 100%, as a fraction.
double parseTolerance(const std::string& text);

// Throws where the method cannot split that many paths over its passes.
void checkSpp(const MethodSpec& method, int spp);

}  // namespace saccade::eval
