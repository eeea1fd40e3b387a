#include "eval/figures/regression.h"

#include <gtest/gtest.h>

#include <cmath>

namespace saccade::eval {
namespace {

TEST(ThroughOrigin, FindsTheSlopeOfLeastSquares) {
  // slope = (1*1 + 2*5) / (1 + 4). The residuals are 1 - 2.2 and 5 - 4.4. The mean is 3.
  const Regression line = throughOrigin({{1, 1}, {2, 5}});
  EXPECT_DOUBLE_EQ(line.slope, 11.0 / 5);
  EXPECT_DOUBLE_EQ(line.r2, 1 - (1.2 * 1.2 + 0.6 * 0.6) / (2.0 * 2 + 2 * 2));
}

TEST(ThroughOrigin, IsCertainOfALine) {
  const Regression line = throughOrigin({{0, 0}, {1, 0.8}, {3, 2.4}});
  EXPECT_DOUBLE_EQ(line.slope, 0.8);
  EXPECT_DOUBLE_EQ(line.r2, 1);
}

TEST(PowerLaw, FindsTheExponentWhateverTheFactor) {
  std::vector<Sample> samples{{0, 1}, {1, 0}};  // no logarithm
  for (const double x : {0.01, 0.1, 3.0}) samples.push_back({x, 7 * std::pow(x, 1.5)});
  const Regression law = powerLaw(samples);
  EXPECT_NEAR(law.slope, 1.5, 1e-12);
  EXPECT_NEAR(law.r2, 1, 1e-12);
  samples.back().y *= 2;
  EXPECT_LT(powerLaw(samples).r2, 1);
}

TEST(Regression, OfNothingIsUnknown) {
  EXPECT_TRUE(std::isnan(throughOrigin({}).slope));
  EXPECT_TRUE(std::isnan(powerLaw({{0, 0}}).slope));
  EXPECT_TRUE(std::isnan(powerLaw({{2, 3}}).slope));
}

}  // namespace
}  // namespace saccade::eval
