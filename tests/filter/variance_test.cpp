#include "filter/variance.h"

#include <gtest/gtest.h>

#include "filter/synthetic.h"

namespace saccade {
namespace {

using test::fillInside;
constexpr int kW = 40, kH = 20;

struct Fixture : ::testing::Test {
  Fixture() {
    test::makeWall(cur);
    test::makeWall(prev);
  }
  TilePool pool{1};
  Frame cur{kW, kH}, prev{kW, kH};
  History history{kW, kH};
  FilterPlanes out{kW, kH};
};

TEST_F(Fixture, LongHistoryGivesTheVarianceOfItsMoments) {
  fillInside(history.length, 4);
  fillInside(history.I, 0.3f);
  fillInside(history.m1, 0.5f);
  fillInside(history.m2, 0.29f);
  fillInside(history.q1, 0.1f);
  fillInside(history.q2, 0.005f);  // below the square of q1, as rounding can make it
  estimateVariance({cur, prev}, history, {}, pool, out);
  EXPECT_NEAR(out.var_i.at(3, 3), 0.04f, 1e-6f);
  EXPECT_EQ(out.var_d.at(3, 3), 0);
  EXPECT_EQ(out.i.at(3, 3), 0.3f);
}

// On a wall all 49 weights of equal signals are 1: the 7x7 variance is that of the 49 values.
TEST_F(Fixture, ShortHistoryLooksAtItsNeighbours) {
  fillInside(history.length, 2);
  double first = 0, second = 0;
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) {
      const float sample = test::randomAt(1, x, y);
      history.m1.at(x, y) = sample;
      history.m2.at(x, y) = sample * sample;
      if (std::abs(x - 20) <= 3 && std::abs(y - 10) <= 3)
        first += sample / 49, second += sample * sample / 49;
    }
  }
  estimateVariance({cur, prev}, history, {}, pool, out);
  EXPECT_NEAR(out.var_i.at(20, 10), (second - first * first) * 4 / 2, 1e-4);
}

TEST_F(Fixture, SmoothsAcrossTheWallButNotAcrossAnEdge) {
  fillInside(history.length, 1);
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) {
      history.I.at(x, y) = x < 20 ? 0 : (x + y) % 2 ? 1.2f : 0.8f;
      if (x >= 20) cur.g.z.at(x, y) = 9;
    }
  }
  estimateVariance({cur, prev}, history, {}, pool, out);
  EXPECT_LT(out.i.at(19, 10), 1e-6f);
  EXPECT_NEAR(out.i.at(20, 10), 1, 0.01f);  // neither the 0 of the left nor the noise of the right
}

}  // namespace
}  // namespace saccade
