#include "client/commands/preview_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>

namespace saccade::client {
namespace {

using Colour = std::array<float, 3>;  // [0, 1]
constexpr Colour kWhite{1, 1, 1}, kRed{0.8f, 0.05f, 0.1f}, kBlue{0.1f, 0.2f, 0.8f};

std::vector<float> planeOf(const std::string& bytes, std::size_t count) {
  if (bytes.size() != count * sizeof(float))
    throw std::runtime_error("the server's picture has the wrong size");
  std::vector<float> plane(count);
  std::memcpy(plane.data(), bytes.data(), bytes.size());
  for (float& value : plane) value = std::isfinite(value) ? value : 0;
  return plane;
}

// Of the absolute values; at least a tiny number, so that it may divide.
float percentile(std::vector<float> values, double fraction) {
  for (float& value : values) value = std::abs(value);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(fraction * (values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return std::max(*at, 1e-12f);
}

Colour mix(Colour from, Colour to, float weight) {
  for (int i = 0; i < 3; ++i) from[i] += weight * (to[i] - from[i]);
  return from;
}

class Canvas {
 public:
  Canvas(int panel_width, int height) : panel_width_(panel_width) {
    picture_.width = 3 * panel_width + 2 * kPanelGap;
    picture_.height = height;
    picture_.pixels.assign(std::size_t{3} * picture_.width * height, 255);
  }
  void set(int panel, int x, int y, Colour colour) {
    const std::size_t at = std::size_t(y) * picture_.width + panel * (panel_width_ + kPanelGap) + x;
    for (int i = 0; i < 3; ++i) {
      picture_.pixels[3 * at + i] =
          static_cast<std::uint8_t>(std::lround(std::clamp(colour[i], 0.0f, 1.0f) * 255));
    }
  }
  RgbPicture take() { return std::move(picture_); }

 private:
  int panel_width_;
  RgbPicture picture_;
};

Colour intensityColour(float relative) {
  const float grey = std::pow(std::clamp(relative, 0.0f, 1.0f), 1 / 2.2f);
  return {grey, grey, grey};
}

Colour changeColour(float relative) {
  return mix(kWhite, relative > 0 ? kRed : kBlue, std::min(std::abs(relative), 1.0f));
}

}  // namespace

RgbPicture drawPreview(const v1::FramePicture& frame, std::span<const Event> events) {
  const int width = static_cast<int>(frame.width()), height = static_cast<int>(frame.height());
  if (width <= 0 || height <= 0) throw std::runtime_error("the server's picture is empty");
  const std::size_t count = std::size_t(width) * height;
  const auto intensity = planeOf(frame.intensity(), count),
             change = planeOf(frame.brightness_change(), count);
  const float exposure = percentile(intensity, 0.99), range = percentile(change, 0.99);
  Canvas canvas(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t i = std::size_t(y) * width + x;
      canvas.set(0, x, y, intensityColour(intensity[i] / exposure));
      canvas.set(1, x, y, changeColour(change[i] / range));
    }
  }
  for (const Event& e : events) {
    if (e.x < width && e.y < height) canvas.set(2, e.x, e.y, e.p ? kRed : kBlue);
  }
  return canvas.take();
}

}  // namespace saccade::client
