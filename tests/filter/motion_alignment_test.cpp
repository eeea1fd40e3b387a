#include "filter/motion_alignment.h"

#include <gtest/gtest.h>

#include "filter/synthetic.h"
#include "frame/pixel_before.h"

namespace saccade {
namespace {

constexpr int kW = 24, kH = 10, kX = 12, kY = 5;

// A textured wall that moves by two pixels, under noisy light.
struct Fixture : ::testing::Test {
  Fixture() {
    for (Frame* f : {&cur, &prev}) test::makeWall(*f);
    test::fillInside(cur.g.motion_x, -2);
    test::fillRandom(prev.samples.I2, 1, 0.2f, 1.8f), test::fillRandom(prev.g.albedo, 2, 0.2f, 0.8f);
    for (int y = 0; y < kH; ++y) {
      for (int x = 0; x < kW; ++x) {
        const PixelPlace p = pixelBefore(cur.g, x, y);
        cur.samples.I1.at(x, y) = prev.samples.I2.at(p.x, p.y);
        cur.g.albedo.at(x, y) = prev.g.albedo.at(p.x, p.y);
        i_prev.at(x, y) = static_cast<float>(x * x);
      }
    }
    test::fillInside(filtered.i, 1000), test::fillInside(filtered.d, 7);
  }
  TilePool pool{1};
  Frame cur{kW, kH}, prev{kW, kH};
  ImageF d{kW, kH}, i_prev{kW, kH};
  FilterPlanes filtered{kW, kH};
};

TEST_F(Fixture, ASurfaceInSteadyLightHasNoDifference) {
  alignDifference({cur, prev}, Demodulation::kAlbedo, pool, d);
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) ASSERT_EQ(d.at(x, y), 0);
  }
  cur.samples.I1.at(kX, kY) *= 2;
  alignDifference({cur, prev}, Demodulation::kAlbedo, pool, d);
  EXPECT_FLOAT_EQ(d.at(kX, kY), prev.samples.I2.at(kX - 2, kY) / prev.g.albedo.at(kX - 2, kY));
  alignDifference({cur, prev}, Demodulation::kNone, pool, d);
  EXPECT_FLOAT_EQ(d.at(kX, kY), prev.samples.I2.at(kX - 2, kY));
}

TEST_F(Fixture, TheCorrectionLeadsBackToThePixel) {
  correctAlignment({cur, prev}, i_prev, pool, filtered);
  EXPECT_FLOAT_EQ(filtered.d.at(kX, kY), 7 + (kX - 2) * (kX - 2) - kX * kX);
}

TEST_F(Fixture, ASurfaceThatAppearsTakesTheDifferenceOfLight) {
  test::fillInside(prev.g.z, 1);
  alignDifference({cur, prev}, Demodulation::kAlbedo, pool, d);
  EXPECT_EQ(d.at(kX, kY), 0);
  correctAlignment({cur, prev}, i_prev, pool, filtered);
  EXPECT_FLOAT_EQ(filtered.d.at(kX, kY), 1000 - kX * kX);
}

}  // namespace
}  // namespace saccade
