#include "filter/anti_firefly.h"

#include <gtest/gtest.h>

#include "filter/synthetic.h"

namespace saccade {
namespace {

constexpr int kW = 12, kH = 9;

struct Fixture : ::testing::Test {
  Fixture() {
    test::makeWall(cur), test::makeWall(prev);
    test::fillRandom(in.i, 1), test::fillRandom(in.d, 2);
    test::fillInside(in.var_i, 3), test::fillInside(in.var_d, 4);
  }
  float largestAround(const ImageF& plane, int x, int y) const {
    float largest = 0;
    for (int k = 0; k < 9; ++k)
      if (k != 4) largest = std::max(largest, plane.at(x + k % 3 - 1, y + k / 3 - 1));
    return largest;
  }
  TilePool pool{1};
  Frame cur{kW, kH}, prev{kW, kH};
  FilterPlanes in{kW, kH}, out{kW, kH};
};

TEST_F(Fixture, ABrightPixelBecomesItsBrightestNeighbour) {
  in.i.at(5, 4) = 100, in.d.at(5, 4) = -100;
  removeFireflies({cur, prev}, in, pool, out);
  EXPECT_EQ(out.i.at(5, 4), largestAround(in.i, 5, 4));
  EXPECT_GE(out.d.at(5, 4), 0);
  EXPECT_EQ(out.var_i.at(5, 4), 3);
  EXPECT_EQ(out.var_d.at(5, 4), 4);
}

// A slope has no pixel beyond all its neighbours.
TEST_F(Fixture, LeavesASlope) {
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) in.i.at(x, y) = static_cast<float>(x + y);
  }
  removeFireflies({cur, prev}, in, pool, out);
  for (int y = 1; y + 1 < kH; ++y) {
    for (int x = 1; x + 1 < kW; ++x) EXPECT_EQ(out.i.at(x, y), in.i.at(x, y));
  }
}

TEST_F(Fixture, APixelOfASurfaceOfItsOwnStays) {
  in.i.at(5, 4) = 100, in.d.at(5, 4) = 100;
  prev.g.z.at(5, 4) = 1;  // it was another surface
  removeFireflies({cur, prev}, in, pool, out);
  EXPECT_LT(out.i.at(5, 4), 1);
  EXPECT_EQ(out.d.at(5, 4), 100);
  cur.g.z.at(5, 4) = 1;
  removeFireflies({cur, prev}, in, pool, out);
  EXPECT_EQ(out.i.at(5, 4), 100);
}

}  // namespace
}  // namespace saccade
