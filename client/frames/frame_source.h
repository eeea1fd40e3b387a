// Frames of a video, one after the other: what `saccade events` sends.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace saccade::client {

// How the numbers of a frame stand for light.
enum class Transfer { kLinear, kSrgb };

// Linear luminance, row by row from the top.
using IntensityFrame = std::vector<float>;

class FrameSource {
 public:
  virtual ~FrameSource() = default;

  // Of all frames, pixels.
  int width() const { return width_; }
  int height() const { return height_; }
  virtual std::optional<std::size_t> frames() const = 0;  // how many, where that is known

  // Returns nothing after the last frame. Throws std::runtime_error with the file at fault.
  virtual std::optional<IntensityFrame> next() = 0;

 protected:
  FrameSource() = default;
  FrameSource(int width, int height) : width_(width), height_(height) {}

  int width_ = 0, height_ = 0;
};

inline constexpr const char* kStandardInput = "-";

std::string sizeText(std::int64_t width, std::int64_t height);
// Says why a frame cannot have this size; empty: it can. The server may allow less.
std::string frameSizeFault(std::int64_t width, std::int64_t height);

// Pictures that OpenImageIO reads, such as EXR and PNG; of a folder all pictures, in the order of the numbers
// in their names. Colours become their Rec. 709 luminance, over black where they have alpha, and whole
// numbers are fractions of their largest value. Without `transfer`, whole numbers are sRGB and other numbers
// are linear. Throws std::invalid_argument where a file is missing or no picture, or there are less than
// two, and as next().
std::unique_ptr<FrameSource> openPictures(const std::vector<std::string>& paths,
                                          std::optional<Transfer> transfer);

// Files of little-endian float32, row by row from the top, with one frame after the other; "-" is the
// standard input. Throws std::invalid_argument where a file is missing, and for a size that cannot be.
std::unique_ptr<FrameSource> openRawFrames(std::vector<std::string> paths, std::int64_t width,
                                           std::int64_t height, Transfer transfer);

// The light of an sRGB value (IEC 61966-2-1). A value above 1 continues the curve, and one below 0 is 0.
float linearFromSrgb(float value);

}  // namespace saccade::client
