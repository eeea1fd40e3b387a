#include "filter/local_regression.h"

#include <gtest/gtest.h>

#include "filter/synthetic.h"

namespace saccade {
namespace {

constexpr int kW = 30, kH = 20, kRadius = 6;

struct Fixture : ::testing::Test {
  Fixture() { test::makeWall(frame); }
  Frame frame{kW, kH};
  ImageF brightness{kW, kH};
};

// First order: what is linear in the features comes back as it is, at the border too.
TEST_F(Fixture, FindsALinearBrightness) {
  test::fillRandom(frame.g.albedo, 1), test::fillRandom(frame.g.nx, 2);
  test::fillRandom(frame.g.z, 3, 4, 6);
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x)
      brightness.at(x, y) = 2 + 3 * frame.g.albedo.at(x, y) - frame.g.nx.at(x, y) + 0.5f * frame.g.z.at(x, y);
  }
  for (const auto& [x, y] : {std::pair{15, 10}, {0, 0}, {kW - 1, 5}}) {
    const LocalModel model = fitLocally(frame.g, brightness, x, y, kRadius);
    EXPECT_NEAR(model.a, brightness.at(x, y), 2e-3f);
    EXPECT_NEAR(model.b[0], 3, 2e-2f);
    EXPECT_NEAR(model.b[1], -1, 2e-2f);
    EXPECT_EQ(model.b[3], 0) << "the window shows one value";
    EXPECT_EQ(model.range[3], 1);
    EXPECT_NEAR(model.range[0], 1, 0.2f);
  }
}

// The weights of both axes leave some 60 of 169 samples, so that noise falls to about a sixth.
TEST_F(Fixture, AveragesNoise) {
  test::fillRandom(brightness, 4, 0.5f, 1.5f);
  double sum = 0;
  int n = 0;
  for (int y = kRadius; y < kH - kRadius; ++y) {
    for (int x = kRadius; x < kW - kRadius; ++x, ++n)
      sum += std::pow(fitLocally(frame.g, brightness, x, y, kRadius).a - 1, 2);
  }
  const double noise = 1 / std::sqrt(12.0);
  EXPECT_LT(std::sqrt(sum / n), 0.25 * noise);
  EXPECT_GT(std::sqrt(sum / n), 0.05 * noise);
}

// Weights fall to 1e-8 at the range of a feature, so that an edge of texture stays sharp.
TEST_F(Fixture, KeepsAnEdgeOfTexture) {
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x)
      frame.g.albedo.at(x, y) = x < 15 ? 0.2f : 0.8f, brightness.at(x, y) = x < 15 ? 1.f : 4.f;
  }
  EXPECT_NEAR(fitLocally(frame.g, brightness, 14, 10, kRadius).a, 1, 1e-3f);
  EXPECT_NEAR(fitLocally(frame.g, brightness, 15, 10, kRadius).a, 4, 1e-3f);
}

TEST_F(Fixture, SeesALampByItsEmission) {
  frame.g.emission.at(15, 10) = 1;
  EXPECT_FLOAT_EQ(featuresAt(frame.g, 15, 10)[0], featuresAt(frame.g, 14, 10)[0] + 0.5f);
}

TEST_F(Fixture, AWindowOfOneValueIsItsMean) {
  test::fillInside(brightness, 7);
  for (ImageF* plane : {&frame.g.z, &frame.g.nz}) test::fillInside(*plane, 0);
  EXPECT_FLOAT_EQ(fitLocally(frame.g, brightness, 0, 0, kRadius).a, 7);
}

}  // namespace
}  // namespace saccade
