#include "eval/metrics/noise_free_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "eval/planes.h"

namespace saccade::eval {
namespace {

using test::plane;

NoiseFreeError errorOf(const ImageF& x, const ImageF& a, const ImageF& b) {
  NoiseFreeError error;
  error.add(x, a, b);
  return error;
}

TEST(NoiseFreeError, ByHand) {
  const ImageF truth = plane({1, -1, 2, 0});  // squares: 6
  const NoiseFreeError half = errorOf(plane({0.5f, -0.5f, 1, 0}), truth, truth);
  EXPECT_DOUBLE_EQ(half.relative(), 0.5);
  EXPECT_DOUBLE_EQ(half.share(), 0.5);
  const NoiseFreeError nothing = errorOf(plane({0, 0, 0, 0}), truth, truth);
  EXPECT_EQ(nothing.relative(), 1);
  EXPECT_EQ(nothing.share(), 0);
  EXPECT_EQ(errorOf(truth, truth, truth).relative(), 0);
  EXPECT_EQ(errorOf(truth, truth, truth).share(), 1);
}

TEST(NoiseFreeError, IsPooledOverFrames) {
  NoiseFreeError error = errorOf(plane({0}), plane({1}), plane({1}));
  error.add(plane({3}), plane({3}), plane({3}));
  EXPECT_DOUBLE_EQ(error.relative(), std::sqrt(1.0 / 10));
  EXPECT_DOUBLE_EQ(error.share(), 9.0 / 10);
}

// The estimate is 0.7 times the truth, with noise of variance 0.25 of its own. The noise of each half is
// twice the truth. An error against their mean would be 1.6. The bounds are five standard deviations.
TEST(NoiseFreeError, IsFreeOfTheNoiseOfTheTruth) {
  constexpr int kSize = 512;
  std::mt19937 random(7);
  std::normal_distribution<float> normal;
  ImageF x(kSize, kSize), a(kSize, kSize), b(kSize, kSize);
  for (int row = 0; row < kSize; ++row) {
    for (int column = 0; column < kSize; ++column) {
      const float truth = normal(random);
      x.at(column, row) = 0.7f * truth + 0.5f * normal(random);
      a.at(column, row) = truth + 2 * normal(random);
      b.at(column, row) = truth + 2 * normal(random);
    }
  }
  const NoiseFreeError error = errorOf(x, a, b);
  EXPECT_NEAR(error.relative(), std::sqrt(0.3 * 0.3 + 0.25), 0.05);
  EXPECT_NEAR(error.share(), 0.7, 0.05);
}

TEST(NoiseFreeError, OfATruthThatIsLostInItsNoiseIsUnknown) {
  const NoiseFreeError lost = errorOf(plane({1, 0}), plane({1, -1}), plane({-1, 1}));
  EXPECT_TRUE(std::isnan(lost.relative()));
  EXPECT_TRUE(std::isnan(lost.share()));
  EXPECT_TRUE(std::isnan(errorOf(plane({0}), plane({0}), plane({0})).relative()));
}

// Halfway between the halves the error squared is below 0.
TEST(NoiseFreeError, ThatIsLostInTheNoiseIsZero) {
  EXPECT_EQ(errorOf(plane({2}), plane({1}), plane({3})).relative(), 0);
}

}  // namespace
}  // namespace saccade::eval
