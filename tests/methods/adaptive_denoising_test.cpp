#include "methods/adaptive_denoising.h"

#include <gtest/gtest.h>

#include "filter/synthetic.h"

namespace saccade {
namespace {

constexpr int kW = 30, kH = 20;

// A standing wall of noisy samples of mean `light`, fresh in every frame.
struct Fixture : ::testing::Test {
  Fixture() {
    test::makeWall(a), test::makeWall(b);
    for (Frame* f : {&a, &b}) f->samples.spp1 = 0;
  }
  void draw(Frame& frame, float light) {
    test::fillRandom(frame.samples.I2, ++seed, 0.5f * light, 1.5f * light);
  }
  void start(Method& method) {
    draw(a, 1);
    method.start(a, pool);
  }
  void step(Method& method, float light) {
    draw(b, light);
    method.estimate({b, a}, pool, change, times);
    std::swap(a, b);
  }
  float largest() const {
    float most = 0;
    for (int y = 0; y < kH; ++y) {
      for (int x = 0; x < kW; ++x) most = std::max(most, std::abs(change.dI.at(x, y)));
    }
    return most;
  }
  std::uint64_t seed = 0;
  TilePool pool{1};
  Frame a{kW, kH}, b{kW, kH};
  IntensityChange change{kW, kH};
  StageTimes times;
};

// The paper's claim: kept parameters make no false events of noise. Its limit: they know features alone, and
// so never hear of a lamp.
TEST_F(Fixture, KeepsItsParametersWhileFeaturesStand) {
  AdaptiveDenoising method({}, kW, kH);
  start(method);
  for (const float light : {1.f, 1.f, 3.f}) {
    step(method, light);
    EXPECT_EQ(largest(), 0);
  }
  EXPECT_NEAR(change.I_now.at(15, 10), 1, 0.3f);
}

TEST_F(Fixture, WithoutAThresholdItFitsEveryFrame) {
  AdaptiveDenoising method({.threshold = 0}, kW, kH);
  start(method);
  step(method, 3);
  EXPECT_NEAR(change.I_now.at(15, 10), 3, 0.9f);
  EXPECT_NEAR(change.dI.at(15, 10), 2, 0.9f);
}

// A checked wall moves by one pixel, so that pixels beside its edge change their texture.
TEST_F(Fixture, FitsAgainWhereFeaturesForetellAnEvent) {
  const auto texture = [](Frame& frame, int edge) {
    for (int y = 0; y < kH; ++y) {
      for (int x = 0; x < kW; ++x) {
        const float albedo = x < edge ? 0.2f : 0.8f;
        frame.g.albedo.at(x, y) = frame.samples.I2.at(x, y) = albedo;
      }
    }
  };
  for (const bool hold : {true, false}) {
    AdaptiveDenoising method({.hold = hold}, kW, kH);
    texture(a, 15), texture(b, 14);
    method.start(a, pool);
    method.estimate({b, a}, pool, change, times);
    EXPECT_NEAR(change.dI.at(14, 10), 0.6f, 1e-2f);
    EXPECT_NEAR(change.I_now.at(14, 10), 0.8f, 1e-2f);
    EXPECT_NEAR(change.dI.at(5, 10), 0, 1e-3f);
  }
}

}  // namespace
}  // namespace saccade
