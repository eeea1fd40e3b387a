#include "client/commands/half_blocks.h"

namespace saccade::client {
namespace {

constexpr const char* kHome = "\x1b[H";
constexpr const char* kPlain = "\x1b[0m";
constexpr const char* kUpperHalf = "\u2580";
constexpr int kForeground = 38, kBackground = 48;

using Rgb = std::array<int, 3>;

Rgb pixelOf(const RgbPicture& picture, int x, int y) {
  if (y >= picture.height) return {0, 0, 0};
  const std::uint8_t* pixel = &picture.pixels[3 * (std::size_t(y) * picture.width + x)];
  return {pixel[0], pixel[1], pixel[2]};
}

void appendColour(std::string& text, int ground, const Rgb& colour) {
  text += "\x1b[" + std::to_string(ground) + ";2";
  for (const int value : colour) text += ";" + std::to_string(value);
  text += "m";
}

}  // namespace

std::string halfBlocks(const RgbPicture& picture) {
  std::string text = kHome;
  for (int y = 0; y < picture.height; y += 2) {
    if (y > 0) text += "\r\n";
    Rgb upper{-1}, lower{-1};  // the colours that are set
    for (int x = 0; x < picture.width; ++x) {
      const Rgb above = pixelOf(picture, x, y), below = pixelOf(picture, x, y + 1);
      if (above != upper) appendColour(text, kForeground, upper = above);
      if (below != lower) appendColour(text, kBackground, lower = below);
      text += kUpperHalf;
    }
    text += kPlain;
  }
  return text;
}

}  // namespace saccade::client
