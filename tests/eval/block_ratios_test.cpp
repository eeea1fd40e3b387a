#include "eval/metrics/block_ratios.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "eval/pictures/ratio_picture.h"

namespace saccade::eval {
namespace {

// value(x, y) is the grey of a pixel.
template <class Value>
RgbPlanes picture(int width, int height, Value value) {
  RgbPlanes planes;
  for (ImageF& plane : planes) {
    plane = ImageF(width, height);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) plane.at(x, y) = static_cast<float>(value(x, y));
    }
  }
  return planes;
}
RgbPlanes grey(int width, int height, double value) {
  return picture(width, height, [&](int, int) { return value; });
}
const auto kLeftIs1RightIs3 = [](int x, int) { return x < 4 ? 1 : 3; };

TEST(BlockRatios, AreOfMeansOverBlocks) {
  // A checkerboard of 0 and 2 has the mean 1.
  const RgbPlanes checks = picture(8, 4, [](int x, int y) { return 2 * ((x + y) % 2); });
  const BlockRatios r = blockRatios(checks, picture(8, 4, kLeftIs1RightIs3), {.edge = 4});
  EXPECT_EQ(r.across, 2);
  EXPECT_EQ(r.down, 1);
  EXPECT_NEAR(r.blocks[0].ratio(), 1, 1e-6);
  EXPECT_NEAR(r.blocks[1].ratio(), 1.0 / 3, 1e-6);
  EXPECT_NEAR(r.meanRatio()[1], 2.0 / 4, 1e-6);
  EXPECT_EQ(r.shareWithin(0.1), 0.5);
  EXPECT_EQ(r.shareWithin(0.7), 1);
}

TEST(BlockRatios, ChannelsHaveTheirOwnMean) {
  RgbPlanes x = grey(4, 4, 1);
  x[2].fill(0.5f);
  const auto [r, g, b] = blockRatios(x, grey(4, 4, 1), {.edge = 2}).meanRatio();
  EXPECT_NEAR(r, 1, 1e-6);
  EXPECT_NEAR(g, 1, 1e-6);
  EXPECT_NEAR(b, 0.5, 1e-6);
}

TEST(BlockRatios, TakeASmallerPictureOfTheSameView) {
  const RgbPlanes small = picture(4, 2, [](int x, int) { return x < 2 ? 1 : 6; });
  const BlockRatios r = blockRatios(small, picture(8, 4, kLeftIs1RightIs3), {.edge = 4});
  EXPECT_NEAR(r.blocks[0].ratio(), 1, 1e-6);
  EXPECT_NEAR(r.blocks[1].ratio(), 2, 1e-6);
  for (const auto& [w, h, edge] :
       {std::array{3, 2, 4}, std::array{4, 4, 4}, std::array{16, 8, 4}, std::array{4, 2, 3}})
    EXPECT_THROW(blockRatios(grey(w, h, 1), grey(8, 4, 1), {.edge = edge}), std::runtime_error)
        << w << "x" << h;
}

TEST(BlockRatios, LeaveOutDarknessRectanglesAndWhatIsNoNumber) {
  RgbPlanes reference = picture(10, 4, [](int x, int y) { return x < 2 && y < 2 ? 0.05 : 1; });
  reference[1].at(9, 3) = INFINITY;
  RgbPlanes x = grey(10, 4, 1);
  x[0].at(8, 0) = NAN;
  const BlockRatios r = blockRatios(x, reference, {.edge = 2, .left_out = {{3, 1, 2, 1}}});
  const std::vector<bool> expected = {false, false, false, true, false,  //
                                      true,  true,  true,  true, false};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(r.blocks[i].compared, expected[i]) << i;
  EXPECT_EQ(r.compared(), 5);
  EXPECT_EQ(r.shareWithin(0.01), 1);
  EXPECT_NEAR(r.meanRatio()[0], 1, 1e-6);
  EXPECT_TRUE(blockRatios(x, reference, {.edge = 2, .least_light = 0.04}).blocks[0].compared);
  EXPECT_THROW(blockRatios(x, grey(10, 4, 0), {.edge = 2}), std::runtime_error);
}

TEST(BlockRatios, PixelsLeftOverAtTheEdgesAreInNoBlock) {
  const BlockRatios r = blockRatios(grey(7, 5, 1), grey(7, 5, 1), {.edge = 3});
  EXPECT_EQ(r.across, 2);
  EXPECT_EQ(r.down, 1);
}

TEST(RatioPicture, ShowsBothAndWhereTheyDiffer) {
  const RgbPlanes x = picture(4, 2, [](int column, int) { return column < 2 ? 1.5 : 0.25; });
  const RgbPlanes reference = picture(4, 2, [](int column, int) { return column < 2 ? 1 : 0.5; });
  const BlockRatios r = blockRatios(x, reference, {.edge = 2});
  const std::vector<GridPicture> pictures = ratioPictures(x, reference, r);
  ASSERT_EQ(pictures.size(), 3u);
  const auto expect = [&](std::size_t panel, std::size_t column, int red, int green, int blue) {
    const Rgb8 pixel = pictures[panel].pixels.at(column);
    EXPECT_EQ(pixel.r, red) << panel << " " << column;
    EXPECT_EQ(pixel.g, green) << panel << " " << column;
    EXPECT_EQ(pixel.b, blue) << panel << " " << column;
  };
  expect(0, 0, 255, 255, 255);  // 1.5 at an exposure of 0.8
  expect(0, 2, 124, 124, 124);  // 0.2 as sRGB
  expect(1, 0, 231, 231, 231);  // 0.8 as sRGB
  expect(2, 0, 255, 0, 0);      // 50 % too bright
  expect(2, 2, 0, 0, 255);      // 50 % too dark
}

}  // namespace
}  // namespace saccade::eval
