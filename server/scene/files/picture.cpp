#include "scene/files/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "pictures/library.h"
#include "scene/files/limits.h"
#include "scene/files/plain_file.h"
#include "scene/files/scene_error.h"
#include "scene/files/srgb.h"

namespace saccade {
namespace {

// NaN becomes 0.
float clampTo(float max, float v) {
  return v > 0 ? std::min(v, max) : 0.0f;
}

// Tabulated for 16 bits, which holds every value of 8- and 16-bit pictures.
float tabulatedFromSrgb(float encoded) {
  static const auto table = [] {
    std::array<float, 65536> values;
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = static_cast<float>(linearFromSrgb(static_cast<double>(i) / 65535));
    }
    return values;
  }();
  return table[static_cast<std::size_t>(std::lround(encoded * 65535))];
}

auto asSceneError(const auto& act) {
  try {
    return act();
  } catch (const std::runtime_error& fault) {
    throw SceneError(fault.what());
  }
}

void checkSize(const std::string& path, const pictures::Shape& shape) {
  const auto within = [](int edge) { return edge >= 1 && edge <= kMaxPictureEdge; };
  if (within(shape.width) && within(shape.height) && shape.pixels() <= kMaxPicturePixels) return;
  throw SceneError(path + ": a picture of " + std::to_string(shape.width) + " x " +
                   std::to_string(shape.height) + "; sides of 1 to " + std::to_string(kMaxPictureEdge) +
                   " and at most " + std::to_string(kMaxPicturePixels) + " pixels are supported");
}

// Refuses a small file that claims to hold many pixels, before memory is taken for them.
void checkBytes(const std::string& path, const pictures::Shape& shape, std::size_t bytes) {
  if (shape.pixels() / kMaxPicturePixelsPerByte <= bytes) return;
  throw SceneError(path + ": a picture of " + std::to_string(shape.width) + " x " +
                   std::to_string(shape.height) + " cannot be in a file of " + std::to_string(bytes) +
                   " bytes");
}

std::unique_ptr<pictures::Input> openChecked(const PictureFile& source) {
  const std::size_t bytes = source.bytes ? source.bytes->size() : plainFileSize(source.name);
  auto input = asSceneError([&] {
    return source.bytes ? pictures::library().openBytes(*source.bytes, source.name)
                        : pictures::library().open(source.name);
  });
  checkSize(source.name, input->shape());
  checkBytes(source.name, input->shape(), bytes);
  return input;
}

void readChannels(pictures::Input& input, int first, int count, Picture& picture) {
  asSceneError([&] { input.read(first, count, &picture.pixels[0].x, sizeof(Rgb)); });
}

// Fills the picture with its alpha. Returns whether it is clear anywhere.
bool readAlpha(pictures::Input& input, Picture& picture) {
  const int alpha = input.shape().alpha;
  if (alpha < 0) return false;
  readChannels(input, alpha, 1, picture);
  for (Rgb& c : picture.pixels) c.x = c.y = c.z = clampTo(1, c.x);
  return std::ranges::any_of(picture.pixels, [](Rgb c) { return c.x < 1; });
}

bool isRaw(PixelUse use) {
  return use == PixelUse::kRawReflectance || use == PixelUse::kRawOpacity || use == PixelUse::kRawRadiance;
}
bool isRadiance(PixelUse use) {
  return use == PixelUse::kRadiance || use == PixelUse::kRawRadiance;
}

}  // namespace

std::size_t countPixels(const PictureFile& source) {
  return openChecked(source)->shape().pixels();
}

Picture loadPicture(const PictureFile& source, PixelUse use) {
  const auto input = openChecked(source);
  const pictures::Shape& shape = input->shape();
  const bool grey = shape.channels.size() < 3;
  Picture picture{shape.width, shape.height, std::vector<Rgb>(shape.pixels())};
  const bool opacity = use == PixelUse::kOpacity || use == PixelUse::kRawOpacity;
  if (opacity && readAlpha(*input, picture)) return picture;
  if (use == PixelUse::kAlpha) {
    if (shape.alpha < 0)
      std::ranges::fill(picture.pixels, Rgb{1, 1, 1});
    else
      readAlpha(*input, picture);
    return picture;
  }
  readChannels(*input, 0, grey ? 1 : 3, picture);
  const bool integers = shape.number == pictures::Number::kU8 || shape.number == pictures::Number::kU16;
  const bool encoded = integers && !isRaw(use);
  const float max = isRadiance(use) ? kMaxRadiance : 1;
  const auto linear = [&](float v) { return encoded ? tabulatedFromSrgb(clampTo(1, v)) : clampTo(max, v); };
  for (Rgb& c : picture.pixels) {
    if (grey) c.y = c.z = c.x;
    c = {linear(c.x), linear(c.y), linear(c.z)};
  }
  return picture;
}

}  // namespace saccade
