#include "methods/path_traced.h"

#include <gtest/gtest.h>

#include "filter/synthetic.h"

namespace saccade {
namespace {

struct Fixture : ::testing::Test {
  Fixture() {
    test::fillRandom(cur.samples.I1, 1), test::fillRandom(cur.samples.I2, 2);
    test::fillRandom(prev.samples.I1, 3), test::fillRandom(prev.samples.I2, 4);
  }
  float c1() const { return cur.samples.I1.at(2, 1); }
  float c2() const { return cur.samples.I2.at(2, 1); }
  float p1() const { return prev.samples.I1.at(2, 1); }
  float p2() const { return prev.samples.I2.at(2, 1); }
  void estimate(const MethodInfo& info) {
    info.make({{}, 8, 4, 2})->estimate({cur, prev}, pool, change, times);
  }

  TilePool pool{1};
  Frame cur{8, 4}, prev{8, 4};
  IntensityChange change{8, 4};
  StageTimes times;
};

TEST_F(Fixture, CorrelatedUsesThePassesThatShareSeeds) {
  estimate(PathTraced::correlatedInfo());
  EXPECT_FLOAT_EQ(change.dI.at(2, 1), c1() - p2());  // [E (8)]
  EXPECT_FLOAT_EQ(change.I_prev.at(2, 1), (p1() + p2()) / 2);
  EXPECT_FLOAT_EQ(change.I_now.at(2, 1), (c1() + c2()) / 2);
}

TEST_F(Fixture, IndependentUsesTheOnlyPass) {
  estimate(PathTraced::independentInfo());
  EXPECT_FLOAT_EQ(change.dI.at(2, 1), c2() - p2());
  EXPECT_FLOAT_EQ(change.I_prev.at(2, 1), p2());
}

}  // namespace
}  // namespace saccade
