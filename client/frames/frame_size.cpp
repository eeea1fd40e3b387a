#include <algorithm>

#include "client/frames/frame_source.h"
#include "saccade/wire/ranges.h"

namespace saccade::client {

std::string sizeText(std::int64_t width, std::int64_t height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

std::string frameSizeFault(std::int64_t width, std::int64_t height) {
  const auto [least, most] = ranges::kViewSide;
  const bool sides = std::min(width, height) >= least && std::max(width, height) <= most;
  if (sides && width * height <= ranges::kMaxPushedPixels) return {};
  return "a frame has " + std::to_string(least) + " to " + std::to_string(most) +
         " pixels on each side and at most " + std::to_string(ranges::kMaxPushedPixels) +
         " in all, but this one has " + sizeText(width, height);
}

}  // namespace saccade::client
