// A picture in memory, with words on it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace saccade::client {

using Colour = std::array<float, 3>;  // red, green, blue, in [0, 1]
inline constexpr Colour kWhite{1, 1, 1}, kBlack{0, 0, 0}, kRed{0.8f, 0.05f, 0.1f}, kBlue{0.1f, 0.2f, 0.8f};

Colour mix(Colour from, Colour to, float weight);  // `from` at 0, `to` at 1

// Pixels right of and below a picture are not drawn.
struct RgbPicture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels = {};  // 3 bytes each, row by row from the top

  void put(int x, int y, Colour colour);
  // Writes one line of 7 pixels' height with its top left at x, y. Returns the x behind it.
  int write(int x, int y, const std::string& text, Colour colour);
};

inline constexpr int kLetterWidth = 6;  // pixels, with the gap

RgbPicture whitePicture(int width, int height);

// Equal pictures give equal bytes. Throws std::runtime_error with the file's name.
void writePng(const std::string& path, const RgbPicture& picture);

}  // namespace saccade::client
