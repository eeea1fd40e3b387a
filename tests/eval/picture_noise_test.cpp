#include "eval/metrics/picture_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "eval/planes.h"

namespace saccade::eval {
namespace {

using test::plane;

RgbPlanes picture(const ImageF& red, const ImageF& green, const ImageF& blue) {
  RgbPlanes planes;
  const ImageF* channels[] = {&red, &green, &blue};
  for (std::size_t c = 0; c < planes.size(); ++c) {
    planes[c] = ImageF(red.width(), red.height());
    planes[c].copyFrom(*channels[c]);
  }
  return planes;
}
RgbPlanes grey(const ImageF& luminance) {
  return picture(luminance, luminance, luminance);
}

// The errors are 3, 0, 0 and -1, and the mean luminance is 2.
TEST(RelativeNoise, IsTheRootMeanSquareOverTheMeanLuminance) {
  const RgbPlanes reference = grey(plane({1, 4, 2, 1}));
  EXPECT_NEAR(relativeNoise(grey(plane({4, 4, 2, 0})), reference), std::sqrt(10 / 4.0) / 2, 1e-6);
  EXPECT_EQ(relativeNoise(reference, reference), 0);
}

// Rec. 709: an error of red alone counts by its share of the luminance.
TEST(RelativeNoise, IsOfLuminance) {
  const ImageF one = plane({1, 1}), off = plane({1.5f, 0.5f});
  EXPECT_NEAR(relativeNoise(picture(off, one, one), grey(one)), 0.2126 * 0.5, 1e-6);
}

TEST(RelativeNoise, OfABlackReferenceIsInfinite) {
  EXPECT_EQ(relativeNoise(grey(plane({0, 1})), grey(plane({0, 0}))), std::numeric_limits<double>::infinity());
  EXPECT_EQ(relativeNoise(grey(plane({0, 0})), grey(plane({0, 0}))), 0);
  EXPECT_TRUE(std::isnan(relativeNoise(grey(plane({NAN, 1})), grey(plane({1, 1})))));
}

}  // namespace
}  // namespace saccade::eval
