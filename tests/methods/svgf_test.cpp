#include "methods/svgf.h"

#include <gtest/gtest.h>

#include "filter/synthetic.h"

namespace saccade {
namespace {

constexpr int kW = 40, kH = 30;

SvgfParams withFaults() {
  SvgfParams params;
  params.as_falcor = true;
  return params;
}

// A standing wall of random samples of mean 1, fresh in every frame.
struct Fixture : ::testing::Test {
  Fixture() {
    test::makeWall(a), test::makeWall(b);
    for (Frame* f : {&a, &b}) f->samples.spp1 = 0, f->samples.spp2 = 2;
  }
  // Runs `frames` frames; the last change is in `change`.
  void run(Svgf& method, int frames) {
    test::fillRandom(a.samples.I2, 1, 0.5f, 1.5f);
    method.start(a, pool);
    Frame *prev = &a, *cur = &b;
    for (int t = 1; t <= frames; ++t) {
      test::fillRandom(cur->samples.I2, static_cast<std::uint64_t>(t + 1), 0.5f, 1.5f);
      method.estimate({*cur, *prev}, pool, change, times);
      std::swap(cur, prev);
    }
  }
  double rmsOf(const ImageF& plane, float mean) const {
    double sum = 0;
    for (int y = 5; y < kH - 5; ++y) {
      for (int x = 5; x < kW - 5; ++x) sum += std::pow(plane.at(x, y) - mean, 2.0);
    }
    return std::sqrt(sum / ((kW - 10) * (kH - 10)));
  }
  TilePool pool{1};
  Frame a{kW, kH}, b{kW, kH};
  IntensityChange change{kW, kH};
  StageTimes times;
};

TEST_F(Fixture, CleansThePictureButItsDifferenceStaysAlive) {
  Svgf method({}, kW, kH);
  run(method, 20);
  const double noise = 1 / std::sqrt(12.0);  // of one sample
  EXPECT_LT(rmsOf(change.I_now, 1), 0.1 * noise);
  // The paper's objection to filtering frames by themselves: a standing wall goes on changing.
  EXPECT_GT(rmsOf(change.dI, 0), 0);
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) {
      ASSERT_FLOAT_EQ(change.dI.at(x, y), change.I_now.at(x, y) - change.I_prev.at(x, y));
    }
  }
}

// Falcor's 7x7 variance of a short history may be negative; what leaves the method must not. Without normals
// every pixel stands alone: its variance is 0 up to rounding, of either sign.
TEST_F(Fixture, VariancesAreNeverNegative) {
  for (Frame* f : {&a, &b}) test::fillInside(f->g.nz, 0);
  Svgf method(withFaults(), kW, kH);
  run(method, 2);
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) {
      ASSERT_GE(change.var_dI.at(x, y), 0) << x << "," << y;
      ASSERT_GE(change.var_I_prev.at(x, y), 0) << x << "," << y;
    }
  }
}

TEST_F(Fixture, EightBitAlbedoMovesTheResultByItsRounding) {
  for (Frame* f : {&a, &b}) test::fillInside(f->g.albedo, 0.5f);  // 0.5 * 255 rounds to 128
  Svgf exact({}, kW, kH), falcor(withFaults(), kW, kH);
  run(exact, 5);
  const float I = change.I_now.at(20, 15);
  run(falcor, 5);
  EXPECT_NE(change.I_now.at(20, 15), I);
  EXPECT_NEAR(change.I_now.at(20, 15), I, 0.05f);
}

}  // namespace
}  // namespace saccade
