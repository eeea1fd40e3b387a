#include "render/lights/lamp_picks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

namespace saccade {
namespace {

std::map<std::uint32_t, float> picksOf(const std::vector<float>& weights, float u) {
  LampPicks picks;
  picks.clear();
  for (std::size_t i = 0; i < weights.size(); ++i) picks.add(static_cast<std::uint32_t>(i), weights[i]);
  std::map<std::uint32_t, float> factors;
  for (const LampPicks::Pick& pick : picks.choose(u))
    EXPECT_TRUE(factors.emplace(pick.lamp, pick.factor).second);
  return factors;
}

TEST(LampPicks, AreAllLampsIfTheyAreFew) {
  const auto factors = picksOf(std::vector<float>(16, 0.5f), 0.3f);
  EXPECT_EQ(factors.size(), 16u);
  for (const auto& [lamp, factor] : factors) EXPECT_EQ(factor, 1);
}

// The strongest come last, and some of those before are as strong as the weakest of them.
TEST(LampPicks, HaveTheStrongestWhole) {
  std::vector<float> weights(60, 1);
  for (std::size_t i = 50; i < 60; ++i) weights[i] = 2;
  const auto factors = picksOf(weights, 0.3f);
  for (std::uint32_t i = 50; i < 60; ++i) EXPECT_EQ(factors.at(i), 1);
  int whole = 0;
  for (const auto& [lamp, factor] : factors) whole += factor == 1;
  EXPECT_EQ(whole, 16);
  EXPECT_EQ(factors.size(), 32u);
}

// Over all numbers, each lamp counts once in the mean.
TEST(LampPicks, HaveTheRightMean) {
  for (const float others : {1e-3f, 0.02f, 1.f}) {
    std::vector<float> weights(16, 4), sums(100);
    for (int i = 0; i < 84; ++i) weights.push_back(others * (1 + std::sin(static_cast<float>(i))) + 1e-6f);
    constexpr int kNumbers = 4096;
    for (int k = 0; k < kNumbers; ++k)
      for (const auto& [lamp, factor] : picksOf(weights, (static_cast<float>(k) + 0.5f) / kNumbers))
        sums[lamp] += factor / kNumbers;
    double error = 0, all = 0;
    for (std::size_t i = 0; i < weights.size(); ++i)
      error += std::abs(sums[i] - 1) * weights[i], all += weights[i];
    EXPECT_LT(error, 2e-3 * all) << others;
  }
}

// Weights that change a little leave nearly all picks as they are.
TEST(LampPicks, StayForEqualNumbers) {
  std::vector<float> weights, moved;
  for (int i = 0; i < 64; ++i) {
    weights.push_back(1 + 0.5f * std::sin(7.f * static_cast<float>(i)));
    moved.push_back(weights.back() * (1 + 1e-4f * std::cos(static_cast<float>(i))));
  }
  int same = 0, all = 0;
  for (int k = 0; k < 64; ++k) {
    const float u = (static_cast<float>(k) + 0.5f) / 64;
    const auto before = picksOf(weights, u), now = picksOf(moved, u);
    for (const auto& [lamp, factor] : now) ++all, same += before.count(lamp) == 1;
  }
  EXPECT_GT(same, 0.99 * all);
}

}  // namespace
}  // namespace saccade
