#include "farm/recipe/draw.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

namespace saccade::farm {
namespace {

constexpr int kDraws = 20000;

double numberAt(const Draw& draw, std::uint64_t address) {
  return std::stod(valueAt(draw, address, 0).texts.at(0));
}

struct Moments {
  double mean = 0, deviation = 0, least = 1e300, greatest = -1e300;
};

Moments momentsOf(const Draw& draw, const auto& map) {
  Moments m;
  double squares = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double value = map(numberAt(draw, static_cast<std::uint64_t>(i)));
    m.mean += value / kDraws, squares += value * value / kDraws;
    m.least = std::min(m.least, value), m.greatest = std::max(m.greatest, value);
  }
  m.deviation = std::sqrt(squares - m.mean * m.mean);
  return m;
}

double same(double value) {
  return value;
}

// The mean of n numbers is within 5 deviations over sqrt(n), in all but one of a million tries.
void expectMoments(const Moments& m, double mean, double deviation) {
  EXPECT_NEAR(m.mean, mean, 5 * deviation / std::sqrt(kDraws));
  EXPECT_NEAR(m.deviation, deviation, 0.02 * deviation);
}

TEST(Draw, UniformHasTheMomentsOfItsInterval) {
  const Draw draw{.kind = Draw::Kind::kUniform, .low = 0.1, .high = 0.5};
  const Moments m = momentsOf(draw, same);
  expectMoments(m, 0.3, 0.4 / std::sqrt(12));
  EXPECT_GE(m.least, 0.1);
  EXPECT_LE(m.greatest, 0.5);
}

TEST(Draw, LogUniformHasTheMomentsOfALogarithm) {
  const Draw draw{.kind = Draw::Kind::kLogUniform, .low = 0.01, .high = 100};
  expectMoments(momentsOf(draw, [](double value) { return std::log10(value); }), 0, 4 / std::sqrt(12));
}

TEST(Draw, IntegersAreEquallyLikelyWithBothEnds) {
  const Draw draw{.kind = Draw::Kind::kInteger, .low = -1, .high = 3};
  std::map<std::string, int> counts;
  for (int i = 0; i < kDraws; ++i) ++counts[valueAt(draw, static_cast<std::uint64_t>(i), 0).texts.at(0)];
  ASSERT_EQ(counts.size(), 5u);
  for (const auto& [text, count] : counts)
    EXPECT_NEAR(count, kDraws / 5, 5 * std::sqrt(kDraws * 0.16)) << text;
}

TEST(Draw, NormalHasItsMomentsWhereTheBoundsAreWide) {
  const Draw draw{.kind = Draw::Kind::kNormal, .low = -100, .high = 100, .mean = 2, .deviation = 3};
  expectMoments(momentsOf(draw, same), 2, 3);
}

// Half of a normal distribution has the mean sqrt(2 / pi) and the variance 1 - 2 / pi.
TEST(Draw, NormalIsCutAtItsBoundsAndNotHeapedThere) {
  const Draw draw{.kind = Draw::Kind::kNormal, .low = 0, .high = 100, .mean = 0, .deviation = 1};
  const double mean = std::sqrt(2 / std::numbers::pi);
  expectMoments(momentsOf(draw, same), mean, std::sqrt(1 - mean * mean));
}

TEST(Draw, ChoicesFollowTheirWeights) {
  const Draw draw{.kind = Draw::Kind::kChoice,
                  .values = {{true, {"a"}}, {true, {"b"}}, {true, {"c"}}},
                  .weights = {1, 0, 3}};
  std::map<std::string, int> counts;
  for (int i = 0; i < kDraws; ++i) ++counts[valueAt(draw, static_cast<std::uint64_t>(i), 0).texts.at(0)];
  EXPECT_EQ(counts["b"], 0);
  EXPECT_NEAR(counts["c"], 0.75 * kDraws, 5 * std::sqrt(kDraws * 0.1875));
}

TEST(Draw, EachTakesTurns) {
  const Draw draw{.kind = Draw::Kind::kEach, .values = {{true, {"a"}}, {true, {"b"}}}};
  EXPECT_EQ(valueAt(draw, 5, 0).texts.at(0), "a");
  EXPECT_EQ(valueAt(draw, 5, 3).texts.at(0), "b");
}

TEST(Draw, ExtremesAreTheEndsOrTheList) {
  EXPECT_EQ(extremes({.kind = Draw::Kind::kUniform, .low = 0.1, .high = 2}),
            (std::vector<Value>{{true, {"0.1"}}, {true, {"2"}}}));
  EXPECT_EQ(extremes({.kind = Draw::Kind::kInteger, .low = 1, .high = 1e6}).back(),
            (Value{true, {"1000000"}}));
  EXPECT_EQ(extremes({.kind = Draw::Kind::kEach, .values = {{true, {"a"}}, {false, {}}}}).size(), 2u);
}

}  // namespace
}  // namespace saccade::farm
