#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "scene/scene_error.h"
#include "scene/texture.h"

namespace saccade {
namespace {

constexpr int kMaxEdge = 16384;

float clampUnit(float v) {
  return v > 0 ? std::min(v, 1.0f) : 0.0f;
}  // NaN becomes 0

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
  OIIO::ImageSpec keep_colours;  // OpenImageIO would multiply them by alpha
  keep_colours.attribute("oiio:UnassociatedAlpha", 1);
  auto input = OIIO::ImageInput::open(path, &keep_colours);
  if (!input) throw SceneError(path + ": " + OIIO::geterror());
  return input;
}

}  // namespace

Texture loadTexture(const std::string& path, bool raw) {
  const auto input = openPicture(path);
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.width < 1 || spec.height < 1 || spec.width > kMaxEdge || spec.height > kMaxEdge)
    throw SceneError(path + ": a picture of " + std::to_string(spec.width) + " x " +
                     std::to_string(spec.height) + "; sides of 1 to " + std::to_string(kMaxEdge) +
                     " are supported");
  const bool encoded =
      !raw && (spec.format == OIIO::TypeDesc::UINT8 || spec.format == OIIO::TypeDesc::UINT16);
  const int channels = spec.nchannels >= 3 ? 3 : 1;
  const std::size_t count = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
  std::vector<float> values(count * static_cast<std::size_t>(channels));
  if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, values.data()))
    throw SceneError(path + ": " + input->geterror());
  for (float& v : values) v = encoded ? linearFromSrgb(clampUnit(v)) : clampUnit(v);
  std::vector<Rgb> pixels(count);
  for (std::size_t i = 0; i < count; ++i)
    pixels[i] = channels == 3 ? Rgb{values[3 * i], values[3 * i + 1], values[3 * i + 2]}
                              : Rgb{values[i], values[i], values[i]};
  return Texture(spec.width, spec.height, std::move(pixels));
}

}  // namespace saccade
