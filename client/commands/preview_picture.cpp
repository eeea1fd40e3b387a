#include "client/commands/preview_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>

#include "client/commands/preview_canvas.h"

namespace saccade::client {
namespace {

std::vector<float> planeOf(const std::string& bytes, std::size_t count) {
  if (bytes.size() != count * sizeof(float))
    throw std::runtime_error("the server's picture has the wrong size");
  std::vector<float> plane(count);
  std::memcpy(plane.data(), bytes.data(), bytes.size());
  for (float& value : plane) value = std::isfinite(value) ? value : 0;
  return plane;
}

// Of the absolute values; at least 1e-12, to divide by.
float percentile(std::vector<float> values, double fraction) {
  for (float& value : values) value = std::abs(value);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(fraction * (values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return std::max(*at, 1e-12f);
}

Colour intensityColour(float relative) {
  const float grey = std::pow(std::clamp(relative, 0.0f, 1.0f), 1 / 2.2f);
  return {grey, grey, grey};
}

Colour changeColour(float relative) {
  return mix(kWhite, relative > 0 ? kRed : kBlue, std::min(std::abs(relative), 1.0f));
}

std::string format(const char* form, double value) {
  char text[64];
  std::snprintf(text, sizeof text, form, value);
  return text;
}

void writeCaptions(PreviewCanvas& canvas, const v1::FramePicture& frame, float white, float full,
                   std::size_t events, std::int64_t window_ns) {
  canvas.write(0, 0, 0, format("intensity at %.6g s", frame.t1_ns() / 1e9), kBlack);
  canvas.write(0, 1, 0, format("white = luminance %.3g", white), kBlack);
  canvas.write(1, 0, 0, format("change of log brightness in %.4g ms", (frame.t1_ns() - frame.t0_ns()) / 1e6),
               kBlack);
  const int middle = canvas.write(1, 1, 0, format("blue = -%.3g  ", full), kBlue);
  canvas.write(1, 1, middle, format("red = +%.3g", full), kRed);
  canvas.write(2, 0, 0, std::to_string(events) + format(" events of the last %.4g ms", window_ns / 1e6),
               kBlack);
  canvas.write(2, 1, canvas.write(2, 1, 0, "red = ON  ", kRed), "blue = OFF", kBlue);
}

}  // namespace

RgbPicture drawPreview(const v1::FramePicture& frame, std::span<const Event> events, std::int64_t window_ns) {
  const int width = static_cast<int>(frame.width()), height = static_cast<int>(frame.height());
  if (width <= 0 || height <= 0) throw std::runtime_error("the server's picture is empty");
  const std::size_t count = std::size_t(width) * height;
  const auto intensity = planeOf(frame.intensity(), count),
             change = planeOf(frame.brightness_change(), count);
  const float exposure = percentile(intensity, 0.99), range = percentile(change, 0.99);
  PreviewCanvas canvas(width, height);
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
  writeCaptions(canvas, frame, exposure, range, events.size(), window_ns);
  return canvas.take();
}

}  // namespace saccade::client
