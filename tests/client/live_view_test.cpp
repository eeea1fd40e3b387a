#include "client/commands/live_view.h"

#include <gtest/gtest.h>

#include <cmath>

#include "client/commands/half_blocks.h"

namespace saccade::client {
namespace {

TEST(HalfBlocks, EachLetterHasTwoPixelsAndColoursAreSetWhereTheyChange) {
  const RgbPicture picture{2, 3, {1, 2, 3, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 10, 11, 12}};
  EXPECT_EQ(halfBlocks(picture),
            "\x1b[H"
            "\x1b[38;2;1;2;3m\x1b[48;2;4;5;6m\u2580\x1b[48;2;7;8;9m\u2580\x1b[0m\r\n"
            "\x1b[38;2;10;11;12m\x1b[48;2;0;0;0m\u2580\u2580\x1b[0m");
}

TEST(TimeSurface, TheNewestEventOfASquareFades) {
  TimeSurface surface(3, 2, 0.001);
  EXPECT_EQ(surface.weight(0, 0, 1, 5'000'000), 0);
  surface.add({{1'000'000, 0, 0, 1}, {2'000'000, 1, 1, 0}});
  EXPECT_FLOAT_EQ(surface.weight(0, 0, 1, 1'000'000), 1);
  EXPECT_FLOAT_EQ(surface.weight(0, 0, 1, 2'000'000), std::exp(-1.0f));
  EXPECT_FLOAT_EQ(surface.weight(0, 0, 2, 2'000'000), -1);
  EXPECT_EQ(surface.weight(2, 0, 2, 2'000'000), 0);  // the square exceeds the image
}

TEST(LiveView, TheImageFillsTheTerminalAboveItsLastLine) {
  EXPECT_EQ(viewOf({80, 24}).width(), 80u);
  EXPECT_EQ(viewOf({80, 24}).height(), 46u);
  EXPECT_EQ(viewOf({80, 1}).height(), 2u);
}

}  // namespace
}  // namespace saccade::client
