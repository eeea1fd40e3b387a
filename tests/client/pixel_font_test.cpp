#include "client/drawing/pixel_font.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace saccade::client {
namespace {

std::string shapeOf(char character) {
  std::string shape;
  for (int y = 0; y < kGlyphHeight; ++y)
    for (int x = 0; x < kGlyphWidth; ++x) shape += isInk(character, x, y) ? '#' : '.';
  return shape;
}

TEST(PixelFont, LettersAndDigitsHaveShapesOfTheirOwn) {
  const std::string characters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789.,:+-%()/= ";
  std::set<std::string> shapes{shapeOf('\x01')};  // of an unknown character
  for (const char c : characters) shapes.insert(shapeOf(c));
  EXPECT_EQ(shapes.size(), characters.size() + 1);
}

TEST(PixelFont, ColumnsRunFromTheLeftAndRowsFromTheTop) {
  EXPECT_EQ(shapeOf('L'), "#....#....#....#....#....#....#####");
}

}  // namespace
}  // namespace saccade::client
