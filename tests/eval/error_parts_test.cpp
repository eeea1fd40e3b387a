#include "eval/metrics/error_parts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "eval/planes.h"

namespace saccade::eval {
namespace {

using test::plane;

RegionMap regionsOf(std::initializer_list<std::uint32_t> values) {
  RegionMap map(static_cast<int>(values.size()), 1);
  std::copy(values.begin(), values.end(), map.row(0));
  return map;
}

TEST(ErrorParts, ByHand) {
  // On the left the mean is 3, the variance 2, and the halves are 1 and 2. The right is another region:
  // exact, but with noise of variance 8.
  Repeats x(2, 1);
  x.add(plane({2, 1})), x.add(plane({4, 5}));
  const ImageF a = plane({1, 3}), b = plane({2, 3});
  const RegionMap regions = regionsOf({region::kSmooth, region::kChanged});

  const ErrorParts left = errorParts(x, a, b, regions, region::kSmooth);
  EXPECT_DOUBLE_EQ(left.bias, std::sqrt(2 * 1 - 2 / 2.0));
  EXPECT_DOUBLE_EQ(left.noise, std::sqrt(2));
  EXPECT_DOUBLE_EQ(left.rms, std::sqrt(1 + 2));
  EXPECT_DOUBLE_EQ(left.offset, 1.5);

  const ErrorParts right = errorParts(x, a, b, regions, region::kChanged);
  EXPECT_DOUBLE_EQ(right.bias, -2);  // a square of 0 - 8 / 2: below what two repeats can see
  EXPECT_DOUBLE_EQ(right.rms, 2);
  EXPECT_EQ(right.offset, 0);

  EXPECT_TRUE(std::isnan(errorParts(x, a, b, regions, region::kCurved).rms));
}

TEST(ErrorParts, AddUpToTheMeanSquareOfTheRepeats) {
  std::mt19937 random(3);
  std::normal_distribution<float> normal;
  const auto draw = [&] {
    ImageF image(16, 1);
    for (int i = 0; i < 16; ++i) image.at(i, 0) = normal(random);
    return image;
  };
  const ImageF a = draw(), b = draw();
  RegionMap regions(16, 1);
  regions.fill(region::kCurved);
  Repeats repeats(16, 1);
  double squares = 0;
  for (int k = 0; k < 5; ++k) {
    const ImageF x = draw();
    repeats.add(x);
    const double rms = rmsError(x, a, b, regions, region::kUnchanged);
    squares += std::copysign(rms * rms, rms) / 5;
  }
  const ErrorParts parts = errorParts(repeats, a, b, regions, region::kUnchanged);
  EXPECT_NEAR(std::copysign(parts.rms * parts.rms, parts.rms), squares, 1e-9);
}

// A known bias of 0.5, noise of 2, and a reference whose halves each have noise of 1. The figures separate
// all three.
TEST(ErrorParts, AreFreeOfTheNoiseOfTheReference) {
  constexpr int kSize = 100, kRepeats = 20;
  std::mt19937 random(4);
  std::normal_distribution<float> normal;
  const auto draw = [&](float mean, float sigma) {
    ImageF image(kSize, kSize);
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) image.at(x, y) = mean + sigma * normal(random);
    }
    return image;
  };
  const ImageF a = draw(7, 1), b = draw(7, 1);
  RegionMap regions(kSize, kSize);
  regions.fill(region::kSmooth);
  Repeats repeats(kSize, kSize);
  for (int k = 0; k < kRepeats; ++k) repeats.add(draw(7.5, 2));
  const ErrorParts parts = errorParts(repeats, a, b, regions, region::kSmooth);
  // Against the mean of the halves, with its variance of 1/2, the bias would be sqrt(1/4 + 1/2) = 0.87. The
  // mean square over 1e4 pixels has a standard deviation of about 0.013.
  EXPECT_NEAR(parts.bias * parts.bias, 0.25, 0.06);
  EXPECT_NEAR(parts.noise, 2, 0.02);
  EXPECT_NEAR(parts.offset, 0.5, 0.04);
}

}  // namespace
}  // namespace saccade::eval
