#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <stdexcept>

#include "client/frames/frame_source.h"

namespace saccade::client {
namespace {

namespace fs = std::filesystem;

bool isPicture(const std::string& path) {
  const bool known = OIIO::ImageInput::create(path) != nullptr;
  if (!known) OIIO::geterror();  // clears it
  return known;
}

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
      if (isPicture(entry.path().string())) files.push_back(entry.path().string());
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
    const auto input = OIIO::ImageInput::open(file);
    if (!input) throw std::runtime_error(file + ": " + OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    if (width_ == 0) width_ = spec.width, height_ = spec.height;
    if (spec.width != width_ || spec.height != height_)
      throw std::runtime_error(file + ": has " + sizeText(spec.width, spec.height) +
                               " pixels, but the first frame has " + sizeText(width_, height_));
    const int channels = spec.nchannels;
    std::vector<float> values(static_cast<std::size_t>(width_) * height_ * channels);
    if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, values.data()))
      throw std::runtime_error(file + ": " + input->geterror());
    return luminanceOf(
        values, channels,
        transfer_.value_or(spec.format.is_floating_point() ? Transfer::kLinear : Transfer::kSrgb));
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
