#include "scene/files/picture.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "scene/files/limits.h"
#include "scene/files/plain_file.h"
#include "scene/files/scene_error.h"

namespace saccade {
namespace {

// NaN becomes 0.
float clampTo(float max, float v) {
  return v > 0 ? std::min(v, max) : 0.0f;
}

// Tabulated for 16 bits, which holds every value of 8- and 16-bit pictures.
float linearFromSrgb(float encoded) {
  static const auto table = [] {
    std::array<float, 65536> values;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double s = static_cast<double>(i) / 65535;
      values[i] = static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
    }
    return values;
  }();
  return table[static_cast<std::size_t>(std::lround(encoded * 65535))];
}

std::unique_ptr<OIIO::ImageInput> openPicture(const std::string& path) {
  OIIO::ImageSpec keep_colours;  // otherwise OpenImageIO multiplies them by alpha
  keep_colours.attribute("oiio:UnassociatedAlpha", 1);
  auto input = OIIO::ImageInput::open(path, &keep_colours);
  if (!input) throw SceneError(path + ": " + OIIO::geterror());
  return input;
}

void checkSize(const std::string& path, const OIIO::ImageSpec& spec) {
  const auto within = [](int edge) { return edge >= 1 && edge <= kMaxPictureEdge; };
  if (within(spec.width) && within(spec.height) && spec.image_pixels() <= kMaxPicturePixels) return;
  throw SceneError(path + ": a picture of " + std::to_string(spec.width) + " x " +
                   std::to_string(spec.height) + "; sides of 1 to " + std::to_string(kMaxPictureEdge) +
                   " and at most " + std::to_string(kMaxPicturePixels) + " pixels are supported");
}

// Refuses a small file that claims to hold many pixels, before memory is taken for them.
void checkBytes(const std::string& path, const OIIO::ImageSpec& spec, std::size_t bytes) {
  if (spec.image_pixels() / kMaxPicturePixelsPerByte <= bytes) return;
  throw SceneError(path + ": a picture of " + std::to_string(spec.width) + " x " +
                   std::to_string(spec.height) + " cannot be in a file of " + std::to_string(bytes) +
                   " bytes");
}

std::unique_ptr<OIIO::ImageInput> openChecked(const std::string& path) {
  const std::size_t bytes = plainFileSize(path);
  auto input = openPicture(path);
  checkSize(path, input->spec());
  checkBytes(path, input->spec(), bytes);
  return input;
}

void readChannels(const std::string& path, OIIO::ImageInput& input, int first, int count, Picture& picture) {
  if (!input.read_image(0, 0, first, first + count, OIIO::TypeDesc::FLOAT, picture.pixels.data(),
                        sizeof(Rgb)))
    throw SceneError(path + ": " + input.geterror());
}

// Fills the picture with its alpha, unless that is 1 all over. Returns whether it did.
bool readAlpha(const std::string& path, OIIO::ImageInput& input, Picture& picture) {
  const int alpha = input.spec().alpha_channel;
  if (alpha < 0) return false;
  readChannels(path, input, alpha, 1, picture);
  for (Rgb& c : picture.pixels) c.x = c.y = c.z = clampTo(1, c.x);
  return std::ranges::any_of(picture.pixels, [](Rgb c) { return c.x < 1; });
}

}  // namespace

std::size_t countPixels(const std::string& path) {
  return openChecked(path)->spec().image_pixels();
}

Picture loadPicture(const std::string& path, PixelUse use) {
  const auto input = openChecked(path);
  const OIIO::ImageSpec& spec = input->spec();
  const bool grey = spec.nchannels < 3;
  Picture picture{spec.width, spec.height, std::vector<Rgb>(spec.image_pixels())};
  const bool opacity = use == PixelUse::kOpacity || use == PixelUse::kRawOpacity;
  if (opacity && readAlpha(path, *input, picture)) return picture;
  readChannels(path, *input, 0, grey ? 1 : 3, picture);
  const bool integers = spec.format == OIIO::TypeDesc::UINT8 || spec.format == OIIO::TypeDesc::UINT16;
  const bool encoded = integers && use != PixelUse::kRawReflectance && use != PixelUse::kRawOpacity;
  const float max = use == PixelUse::kRadiance ? kMaxRadiance : 1;
  const auto linear = [&](float v) { return encoded ? linearFromSrgb(clampTo(1, v)) : clampTo(max, v); };
  for (Rgb& c : picture.pixels) {
    if (grey) c.y = c.z = c.x;
    c = {linear(c.x), linear(c.y), linear(c.z)};
  }
  return picture;
}

}  // namespace saccade
