#include "client/frames/picture.h"

#include <OpenImageIO/imageio.h>

#include <array>
#include <span>
#include <stdexcept>
#include <string_view>

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

Layout layoutOf(const OIIO::ImageSpec& spec, std::optional<Transfer> transfer) {
  Layout layout{weightsOf(spec.nchannels),
                transfer.value_or(spec.format.is_floating_point() ? Transfer::kLinear : Transfer::kSrgb)};
  layout.alpha = spec.alpha_channel == static_cast<int>(layout.weights.size());
  layout.multiplied = spec.get_int_attribute("oiio:UnassociatedAlpha") == 0;
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

// Whether the frames of a video or the pages of a scan are in one file. Parts of OpenEXR are layers of a
// picture.
bool holdsSeveral(OIIO::ImageInput& input) {
  const std::string format = input.format_name();
  if (format != "gif" && format != "tiff") return false;
  const bool several = input.seek_subimage(1, 0);
  input.seek_subimage(0, 0);
  return several;
}

void check(const std::string& file, const OIIO::ImageSpec& spec) {
  if (spec.depth > 1) throw std::runtime_error(file + ": is a volume, no picture");
  const std::string fault = frameSizeFault(spec.width, spec.height);
  if (!fault.empty()) throw std::runtime_error(file + ": " + fault);
}

}  // namespace

bool isPicture(const std::string& file) {
  const auto input = OIIO::ImageInput::create(file);
  if (!input) OIIO::geterror();  // clears it
  return input && std::string_view(input->format_name()) != "ffmpeg";
}

Picture readPicture(const std::string& file, std::optional<Transfer> transfer) {
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  const auto input = OIIO::ImageInput::open(file, &config);
  if (!input) throw std::runtime_error(file + ": " + OIIO::geterror());
  if (holdsSeveral(*input)) throw std::runtime_error(videoAdvice(file));
  const OIIO::ImageSpec& spec = input->spec();
  check(file, spec);
  const Layout layout = layoutOf(spec, transfer);
  Picture picture{spec.width, spec.height, IntensityFrame(spec.image_pixels())};
  std::vector<float> values(picture.light.size() * layout.channels());
  if (!input->read_image(0, 0, 0, static_cast<int>(layout.channels()), OIIO::TypeDesc::FLOAT, values.data()))
    throw std::runtime_error(file + ": " + input->geterror());
  for (std::size_t i = 0; i < picture.light.size(); ++i)
    picture.light[i] = lightOf(&values[i * layout.channels()], layout);
  return picture;
}

std::string videoAdvice(const std::string& file) {
  return "'" + file + "' is no single picture; of a video, let ffmpeg make the frames: ffmpeg -i " + file +
         " -f rawvideo -pix_fmt grayf32le - | saccade events - --size WIDTHxHEIGHT --rate HZ --transfer srgb";
}

}  // namespace saccade::client
