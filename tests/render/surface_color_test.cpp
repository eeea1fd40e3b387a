#include "render/surface/surface_color.h"

#include <gtest/gtest.h>

namespace saccade {
namespace {

TEST(SquareWave, HasItsMeanOverAnInterval) {
  EXPECT_FLOAT_EQ(filteredSquareWave(0.25f, 0.1f), 1);
  EXPECT_FLOAT_EQ(filteredSquareWave(0.75f, 0.1f), -1);
  EXPECT_NEAR(filteredSquareWave(0.5f, 0.2f), 0, 1e-6);
  EXPECT_NEAR(filteredSquareWave(0.45f, 0.2f), 0.5, 1e-6);  // three quarters are +1
  EXPECT_NEAR(filteredSquareWave(0.25f, 1.5f), -1. / 3, 1e-6);
}

// Else a checkerboard with many squares would reflect more light than falls on it.
TEST(SquareWave, OfASmallIntervalFarOutIsItsValueThere) {
  for (const float period : {0.f, 1.f, 1000.f, -50'000.f}) {
    EXPECT_NEAR(filteredSquareWave(period + 0.25f, 1e-7f), 1, 0.01) << period;
    EXPECT_NEAR(filteredSquareWave(period + 0.75f, 1e-7f), -1, 0.01) << period;
    for (const float x : {0.1f, 0.49999f, 0.500003f, 0.9f})
      EXPECT_LE(std::abs(filteredSquareWave(period + x, 1e-7f)), 1) << period;
  }
}

}  // namespace
}  // namespace saccade
