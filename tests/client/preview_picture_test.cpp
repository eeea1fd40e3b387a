#include "client/commands/preview_picture.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "client/commands/preview_canvas.h"

namespace saccade::client {
namespace {

using Rgb8 = std::array<int, 3>;
constexpr Rgb8 kWhite{255, 255, 255};

std::string bytesOf(const std::vector<float>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)};
}

v1::FramePicture frameOf(int width, int height, const std::vector<float>& intensity,
                         const std::vector<float>& change) {
  v1::FramePicture frame;
  frame.set_width(width);
  frame.set_height(height);
  frame.set_intensity(bytesOf(intensity));
  frame.set_brightness_change(bytesOf(change));
  return frame;
}

Rgb8 colour(const RgbPicture& picture, int x, int y) {
  const auto* p = &picture.pixels[3 * (y * picture.width + x)];
  return {p[0], p[1], p[2]};
}

bool isRed(const Rgb8& c) {
  return c[0] > 2 * c[1] && c[0] > 2 * c[2];
}
bool isBlue(const Rgb8& c) {
  return c[2] > 2 * c[0] && c[2] > 2 * c[1];
}

constexpr std::int64_t kWindowNs = 10'000'000;

// The middle of pixel x, y of a panel of a frame that is 3 wide.
Rgb8 at(const RgbPicture& picture, int panel, int x, int y) {
  const PreviewLayout layout(3);
  const int half = layout.zoom / 2;
  return colour(picture, layout.left(panel) + x * layout.zoom + half,
                PreviewLayout::kCaptionHeight + y * layout.zoom + half);
}
constexpr int kIntensity = 0, kChange = 1, kEvents = 2;

TEST(PreviewPicture, PanelsStandSideBySideUnderTheirCaptions) {
  const std::vector<float> zero(6);
  const auto picture = drawPreview(frameOf(3, 2, zero, zero), {}, kWindowNs);
  const PreviewLayout layout(3);
  EXPECT_EQ(layout.zoom, 80);
  EXPECT_EQ(picture.width, 3 * 240 + 2 * PreviewLayout::kGap);
  EXPECT_EQ(picture.height, PreviewLayout::kCaptionHeight + 2 * 80);
  EXPECT_EQ(picture.pixels.size(), std::size_t(3 * picture.width * picture.height));
  EXPECT_EQ(at(picture, kIntensity, 0, 0), (Rgb8{0, 0, 0}));  // no light is black
  EXPECT_EQ(at(picture, kChange, 0, 0), kWhite);              // no change is white
  EXPECT_EQ(at(picture, kEvents, 0, 0), kWhite);
}

TEST(PreviewPicture, AFrameThatIsWideEnoughIsNotZoomed) {
  EXPECT_EQ(PreviewLayout(240).zoom, 1);
  EXPECT_EQ(PreviewLayout(239).zoom, 2);
  EXPECT_EQ(PreviewLayout(346).panel_width, 346);
}

// The words of panel 2 are in the colours of the events that they name.
TEST(PreviewPicture, CaptionsNameTheColours) {
  const std::vector<float> zero(6);
  const auto picture = drawPreview(frameOf(3, 2, zero, zero), {}, kWindowNs);
  const PreviewLayout layout(3);
  std::array<int, 3> red{}, blue{};
  for (int panel = 0; panel < 3; ++panel) {
    for (int y = 0; y < PreviewLayout::kCaptionHeight; ++y) {
      for (int x = 0; x < layout.panel_width; ++x) {
        red[panel] += isRed(colour(picture, layout.left(panel) + x, y));
        blue[panel] += isBlue(colour(picture, layout.left(panel) + x, y));
      }
    }
  }
  EXPECT_EQ(red[0] + blue[0], 0);
  for (int panel : {1, 2}) {
    EXPECT_GT(red[panel], 30) << panel;
    EXPECT_GT(blue[panel], 30) << panel;
  }
}

TEST(PreviewPicture, IntensityIsExposedAndHasGamma) {
  const auto picture = drawPreview(frameOf(3, 2, {8, 8, 8, 2, 0, 8}, std::vector<float>(6)), {}, kWindowNs);
  EXPECT_EQ(at(picture, kIntensity, 0, 0), kWhite);
  EXPECT_EQ(at(picture, kIntensity, 1, 1), (Rgb8{0, 0, 0}));
  const int grey = static_cast<int>(std::lround(255 * std::pow(0.25, 1 / 2.2)));
  EXPECT_EQ(at(picture, kIntensity, 0, 1), (Rgb8{grey, grey, grey}));
}

TEST(PreviewPicture, ChangeIsSymmetricInItsColours) {
  const auto picture =
      drawPreview(frameOf(3, 2, std::vector<float>(6), {1, -1, 0, 0.5, -0.5, 1}), {}, kWindowNs);
  EXPECT_TRUE(isRed(at(picture, kChange, 0, 0)));
  EXPECT_TRUE(isBlue(at(picture, kChange, 1, 0)));
  EXPECT_EQ(at(picture, kChange, 2, 0), kWhite);
  // Half the change is half way to white.
  EXPECT_NEAR(at(picture, kChange, 0, 1)[1], (255 + at(picture, kChange, 0, 0)[1]) / 2.0, 1);
  EXPECT_NEAR(at(picture, kChange, 1, 1)[0], (255 + at(picture, kChange, 1, 0)[0]) / 2.0, 1);
}

TEST(PreviewPicture, TheLatestEventOfAPixelIsOnTop) {
  const std::vector<float> zero(6);
  const Events events{
      {0, 0, 0, 0}, {1000, 2, 1, 0}, {2000, 0, 0, 1}, {3000, 3, 0, 1}};  // the last is outside
  const auto picture = drawPreview(frameOf(3, 2, zero, zero), events, kWindowNs);
  EXPECT_TRUE(isRed(at(picture, kEvents, 0, 0)));
  EXPECT_TRUE(isBlue(at(picture, kEvents, 2, 1)));
  EXPECT_EQ(at(picture, kEvents, 1, 0), kWhite);
}

TEST(PreviewPicture, NaNIsDrawnAsZero) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  const auto picture =
      drawPreview(frameOf(3, 2, {nan, inf, 1, 1, 1, 1}, {nan, -inf, 1, 1, 1, 1}), {}, kWindowNs);
  EXPECT_EQ(at(picture, kIntensity, 0, 0), (Rgb8{0, 0, 0}));
  EXPECT_EQ(at(picture, kChange, 1, 0), kWhite);
}

TEST(PreviewPicture, PlanesThatDoNotFitAreRefused) {
  const std::vector<float> zero(6);
  EXPECT_THROW(drawPreview(frameOf(3, 3, zero, zero), {}, kWindowNs), std::runtime_error);
  EXPECT_THROW(drawPreview(frameOf(0, 0, {}, {}), {}, kWindowNs), std::runtime_error);
  EXPECT_THROW(drawPreview(frameOf(-1, 2, zero, zero), {}, kWindowNs), std::runtime_error);
}

}  // namespace
}  // namespace saccade::client
