#include <bit>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "client/frames/frame_source.h"

namespace saccade::client {
namespace {

static_assert(std::endian::native == std::endian::little, "frames are read as they lie in memory");

class RawFrames final : public FrameSource {
 public:
  RawFrames(std::vector<std::string> paths, int width, int height, Transfer transfer)
      : FrameSource(width, height), paths_(std::move(paths)), transfer_(transfer) {}

  std::optional<std::size_t> frames() const override { return std::nullopt; }

  std::optional<IntensityFrame> next() override {
    IntensityFrame frame(static_cast<std::size_t>(width_) * height_);
    while (at_ < paths_.size()) {
      if (readInto(frame)) return frame;
      file_ = {};
      ++at_;
    }
    return std::nullopt;
  }

 private:
  // Returns false at the end of the present file.
  bool readInto(IntensityFrame& frame) {
    const std::string& path = paths_[at_];
    const bool standard = path == kStandardInput;
    if (!standard && !file_.is_open()) file_.open(path, std::ios::binary);
    std::istream& input = standard ? std::cin : file_;
    const auto bytes = static_cast<std::streamsize>(frame.size() * sizeof(float));
    input.read(reinterpret_cast<char*>(frame.data()), bytes);
    if (input.gcount() == 0 && input.eof()) return false;
    if (input.gcount() != bytes)
      throw std::runtime_error(path + ": ends within a frame, or is not of this size");
    if (transfer_ == Transfer::kSrgb) {
      for (float& value : frame) value = linearFromSrgb(value);
    }
    return true;
  }

  const std::vector<std::string> paths_;
  const Transfer transfer_;
  std::ifstream file_;  // the present one
  std::size_t at_ = 0;  // its index
};

}  // namespace

std::unique_ptr<FrameSource> openRawFrames(std::vector<std::string> paths, std::int64_t width,
                                           std::int64_t height, Transfer transfer) {
  for (const std::string& path : paths) {
    if (std::filesystem::is_directory(path))
      throw std::invalid_argument(
          "'" + path + "' is a folder: with --size, frames are raw files; leave it out for pictures");
    if (path != kStandardInput && !std::filesystem::is_regular_file(path))
      throw std::invalid_argument("there is no file '" + path + "'");
  }
  const std::string fault = frameSizeFault(width, height);
  if (!fault.empty()) throw std::invalid_argument(fault);
  return std::make_unique<RawFrames>(std::move(paths), static_cast<int>(width), static_cast<int>(height),
                                     transfer);
}

}  // namespace saccade::client
