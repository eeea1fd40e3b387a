#include "base/quantile.h"

#include <gtest/gtest.h>

namespace saccade {
namespace {

TEST(Quantile, IsTheValueOfItsRank) {
  std::vector<int> values{40, 10, 50, 20, 30};
  const int sorted[] = {10, 20, 30, 40, 50};
  for (int rank = 0; rank < 5; ++rank) EXPECT_EQ(quantile(values, rank / 4.0), sorted[rank]);
  EXPECT_EQ(quantile(values, 0.49), 20);  // between ranks the lower one
}

TEST(Quantile, OfOneValueIsThatValue) {
  std::vector<float> values{7};
  for (const double fraction : {0.0, 0.5, 1.0}) EXPECT_EQ(quantile(values, fraction), 7);
}

TEST(Quantile, OfNothingIsALogicFault) {
  std::vector<float> none;
  EXPECT_DEATH(quantile(none, 0.5), "values.empty");
}

}  // namespace
}  // namespace saccade
