#include "eval/figures/spectrum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace saccade::eval {
namespace {

constexpr double kRate = 200;  // Hz

std::vector<double> sine(int frames, double hz, double amplitude) {
  std::vector<double> x;
  for (int t = 0; t < frames; ++t)
    x.push_back(3 + amplitude * std::cos(2 * std::numbers::pi * hz * t / kRate + 0.7));
  return x;
}

// The window spreads a sine over three steps, with 1/6, 4/6 and 1/6 of its power.
TEST(PowerSpectrum, FindsASineWhereItIsWithItsPower) {
  for (const int frames : {100, 125}) {
    const Spectrum s = powerSpectrum(sine(frames, 24, 0.5), kRate);
    const auto peak = std::max_element(s.density.begin(), s.density.end());
    const auto k = static_cast<std::size_t>(peak - s.density.begin());
    EXPECT_DOUBLE_EQ(s.step_hz, kRate / frames);
    EXPECT_NEAR(s.hz(k), 24, 1e-9) << frames;
    const double power = 0.5 * 0.5 / 2;
    EXPECT_NEAR(*peak * s.step_hz, power * 4 / 6, 1e-9) << frames;
    EXPECT_NEAR(s.powerAbove(0), power, 1e-9) << frames;
    EXPECT_NEAR(s.powerAbove(20), power, 1e-9) << frames;
    EXPECT_NEAR(s.powerAbove(30), 0, 1e-9) << frames;
  }
}

// The density of white noise is the same everywhere up to half the rate. Half the rate has no mirror image.
TEST(PowerSpectrum, SpreadsNoiseEvenly) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0, 0.1);
  Spectrum sum;
  const int kSeries = 4000;
  for (int i = 0; i < kSeries; ++i) {
    std::vector<double> x(16);
    for (double& v : x) v = normal(random);
    sum += powerSpectrum(x, kRate);
  }
  ASSERT_EQ(sum.density.size(), 8u);
  EXPECT_DOUBLE_EQ(sum.hz(7), kRate / 2);
  const double density = 0.01 / (kRate / 2);  // sigma^2 over 0 to half the rate
  // The first step lacks the mean. The density itself varies, at half the rate sqrt(2) times as much. The
  // bound is five sigma.
  for (std::size_t k = 1; k < 7; ++k)
    EXPECT_NEAR(sum.density[k] / kSeries / density, 1, 5 / std::sqrt(kSeries)) << k;
  EXPECT_NEAR(sum.density[7] / kSeries / density, 0.5, 5 / std::sqrt(kSeries));
}

TEST(PowerSpectrum, OfAConstantIsNothing) {
  for (const double density : powerSpectrum({2, 2, 2, 2, 2}, kRate).density) EXPECT_NEAR(density, 0, 1e-30);
}

}  // namespace
}  // namespace saccade::eval
