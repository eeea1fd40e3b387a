// Reads the values of flags. All throw CLI::ValidationError, a std::runtime_error, which names the flag and
// the valid values.
#pragma once

#include <string>
#include <vector>

#include "methods/method_spec.h"

namespace saccade::eval {

struct Size {
  int width = 256, height = 256;
};
// "WxH", 1 to 16384 each.
Size parseSize(const std::string& text);

struct FrameRange {
  int first = 1, last = 21;
  FrameRange firstHalf() const { return {first, first + (last - first) / 2}; }
};
// "A:B", frames A to B with 1 <= A <= B <= 1,000,000 (the change of frame 1 is since frame 0), or one frame.
FrameRange parseFrameRange(const std::string& text);

// "2%" as the fraction 0.02; over 0% and up to 100%.
double parseTolerance(const std::string& text);

// A method with its paths per pixel and frame.
struct Setting {
  MethodSpec method;
  int spp = 2;
  std::string text() const { return method.text + '@' + std::to_string(spp); }
};
// "METHOD@SPP": "svgf:as_falcor=1@4". Throws also where the method's passes cannot share so many paths;
// `flag` is for the message.
Setting parseSetting(const std::string& flag, const std::string& text);

// Throws unless the method's passes can share that many paths.
void checkSpp(const MethodSpec& method, int spp);
// The same for each method with each number.
void checkSpp(const std::vector<std::string>& methods, const std::vector<int>& spp);

// Throws unless a file with one of these extensions can be written there: its folder must exist.
void checkOutputFile(const std::string& path, const std::vector<std::string>& extensions);

}  // namespace saccade::eval
