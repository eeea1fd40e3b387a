#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <stdexcept>

#include "client/frames/frame_source.h"
#include "pictures/library.h"

namespace saccade::client {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> filesOf(const std::vector<std::string>& paths) {
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    if (!fs::exists(path)) throw std::invalid_argument("there is no file '" + path + "'");
    if (!fs::is_directory(path)) {
      files.push_back(path);
      continue;
    }
    const auto first = static_cast<std::ptrdiff_t>(files.size());
    for (const auto& entry : fs::directory_iterator(path)) {
      if (pictures::library().canRead(entry.path().string())) files.push_back(entry.path().string());
    }
    std::sort(files.begin() + first, files.end());
  }
  if (files.size() < 2) throw std::invalid_argument("events need at least two frames");
  return files;
}

// The weights of a picture's first channels: grey, or red, green and blue.
std::span<const float> weightsOf(int channels) {
  static constexpr std::array kGrey{1.0f};
  static constexpr std::array kColours{0.2126f, 0.7152f, 0.0722f};
  if (channels < 3) return kGrey;
  return kColours;
}

class Pictures final : public FrameSource {
 public:
  Pictures(std::vector<std::string> files, std::optional<Transfer> transfer)
      : files_(std::move(files)), transfer_(transfer) {
    first_ = read(files_.front());
  }

  std::optional<std::size_t> frames() const override { return files_.size(); }

  std::optional<IntensityFrame> next() override {
    if (at_ == files_.size()) return std::nullopt;
    const std::string& file = files_[at_++];
    return at_ == 1 ? std::move(first_) : read(file);
  }

 private:
  IntensityFrame read(const std::string& file) {
    const auto input = pictures::library().open(file);
    const pictures::Shape& shape = input->shape();
    if (width_ == 0) width_ = shape.width, height_ = shape.height;
    if (shape.width != width_ || shape.height != height_)
      throw std::runtime_error(file + ": has " + sizeText(shape.width, shape.height) +
                               " pixels, but the first frame has " + sizeText(width_, height_));
    const auto channels = static_cast<int>(shape.channels.size());
    std::vector<float> values(shape.pixels() * channels);
    input->read(0, channels, values.data(), channels * sizeof(float));
    return luminanceOf(
        values, channels,
        transfer_.value_or(pictures::isWhole(shape.number) ? Transfer::kSrgb : Transfer::kLinear));
  }

  static std::string sizeText(int width, int height) {
    return std::to_string(width) + "x" + std::to_string(height);
  }

  static IntensityFrame luminanceOf(const std::vector<float>& values, int channels, Transfer transfer) {
    const std::span<const float> weights = weightsOf(channels);
    const auto stride = static_cast<std::size_t>(channels);
    IntensityFrame frame(values.size() / stride);
    for (std::size_t i = 0; i < frame.size(); ++i) {
      for (std::size_t c = 0; c < weights.size(); ++c) {
        const float value = values[i * stride + c];
        frame[i] += weights[c] * (transfer == Transfer::kSrgb ? linearFromSrgb(value) : value);
      }
    }
    return frame;
  }

  const std::vector<std::string> files_;
  const std::optional<Transfer> transfer_;
  IntensityFrame first_;
  std::size_t at_ = 0;
};

}  // namespace

std::unique_ptr<FrameSource> openPictures(const std::vector<std::string>& paths,
                                          std::optional<Transfer> transfer) {
  return std::make_unique<Pictures>(filesOf(paths), transfer);
}

}  // namespace saccade::client
