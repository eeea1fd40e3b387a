#include "methods/join_estimates.h"

#include <gtest/gtest.h>

#include "base/tile_pool.h"

namespace saccade {
namespace {

constexpr int kSize = 8;

struct JoinEstimatesTest : testing::Test {
  void join(float value, float var, float value_other, float var_other) {
    own.fill(value), var_own.fill(var), other.fill(value_other), this->var_other.fill(var_other);
    joinAll();
  }
  void joinAll() { joinEstimates({own, var_own}, {other, var_other}, pool, joined, variance); }

  TilePool pool{2};
  ImageF own{kSize, kSize}, var_own{kSize, kSize}, other{kSize, kSize}, var_other{kSize, kSize};
  ImageF joined{kSize, kSize}, variance{kSize, kSize};
};

TEST_F(JoinEstimatesTest, ThatAgreeCountByTheirVariances) {
  join(1, 3, 2, 1);  // apart by less than their noise: w = 3/4
  EXPECT_FLOAT_EQ(joined.at(3, 4), 1.75f);
  EXPECT_FLOAT_EQ(variance.at(3, 4), 3 / 16.f + 9 / 16.f);
}

TEST_F(JoinEstimatesTest, TheOtherOneCountsLessAsTheyDiffer) {
  join(0, 1, 10, 1);  // b^2 = 98
  EXPECT_FLOAT_EQ(joined.at(0, 7), 0.1f);
}

TEST_F(JoinEstimatesTest, WhereThereIsNoOtherItIsTheOwn) {
  join(1, 3, 2, 1);
  var_other.at(3, 4) = kNoEstimate;
  other.at(3, 4) = 1e6f;  // its neighbours do not read it either
  joinAll();
  EXPECT_EQ(joined.at(3, 4), 1);
  EXPECT_EQ(variance.at(3, 4), 3);
  EXPECT_FLOAT_EQ(joined.at(4, 4), 1.75f);
}

}  // namespace
}  // namespace saccade
