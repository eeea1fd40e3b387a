#include "client/frames/picture.h"

#include <array>
#include <span>
#include <stdexcept>

#include "pictures/library.h"

namespace saccade::client {
namespace {

// The weights of a picture's first channels: grey, or red, green and blue.
std::span<const float> weightsOf(int channels) {
  static constexpr std::array kGrey{1.0f};
  static constexpr std::array kColours{0.2126f, 0.7152f, 0.0722f};
  if (channels < 3) return kGrey;
  return kColours;
}

struct Layout {
  std::span<const float> weights;
  Transfer transfer;
  bool alpha = false;       // follows the colours
  bool multiplied = false;  // the colours have been multiplied by it, as they stand in the file

  std::size_t channels() const { return weights.size() + (alpha ? 1 : 0); }
};

Layout layoutOf(const pictures::Shape& shape, std::optional<Transfer> transfer) {
  const bool whole = pictures::isWhole(shape.number);
  Layout layout{weightsOf(static_cast<int>(shape.channels.size())),
                transfer.value_or(whole ? Transfer::kSrgb : Transfer::kLinear)};
  layout.alpha = shape.alpha == static_cast<int>(layout.weights.size());
  layout.multiplied = shape.multiplied;
  return layout;
}

// Colours are decoded before alpha lies on them: over black.
float lightOf(const float* pixel, const Layout& layout) {
  const float alpha = layout.alpha ? pixel[layout.weights.size()] : 1;
  const bool srgb = layout.transfer == Transfer::kSrgb;
  const bool divide = srgb && layout.multiplied && alpha > 0;
  float light = 0;
  for (std::size_t c = 0; c < layout.weights.size(); ++c) {
    const float value = divide ? pixel[c] / alpha : pixel[c];
    light += layout.weights[c] * (srgb ? linearFromSrgb(value) : value);
  }
  return layout.multiplied && !divide ? light : light * alpha;
}

void check(const std::string& file, const pictures::Shape& shape) {
  if (shape.several) throw std::runtime_error(videoAdvice(file));
  const std::string fault = frameSizeFault(shape.width, shape.height);
  if (!fault.empty()) throw std::runtime_error(file + ": " + fault);
}

}  // namespace

bool isPicture(const std::string& file) {
  return pictures::library().canRead(file);
}

Picture readPicture(const std::string& file, std::optional<Transfer> transfer) {
  const auto input = pictures::library().open(file);
  const pictures::Shape& shape = input->shape();
  check(file, shape);
  const Layout layout = layoutOf(shape, transfer);
  Picture picture{shape.width, shape.height, IntensityFrame(shape.pixels())};
  const std::size_t channels = layout.channels();
  std::vector<float> values(picture.light.size() * channels);
  input->read(0, static_cast<int>(channels), values.data(), channels * sizeof(float));
  for (std::size_t i = 0; i < picture.light.size(); ++i)
    picture.light[i] = lightOf(&values[i * channels], layout);
  return picture;
}

std::string videoAdvice(const std::string& file) {
  return "'" + file + "' is not a single picture; of a video, let ffmpeg make the frames: ffmpeg -i " + file +
         " -f rawvideo -pix_fmt grayf32le - | saccade events - --size WIDTHxHEIGHT --rate HZ --transfer srgb";
}

}  // namespace saccade::client
