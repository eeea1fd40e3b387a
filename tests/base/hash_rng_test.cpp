#include "base/hash_rng.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <set>

namespace saccade {
namespace {

// SplitMix64 with seed 0: the first outputs as its author's reference code prints them.
TEST(Mix64, IsTheFinaliserOfSplitMix64) {
  EXPECT_EQ(mix64(0x9e3779b97f4a7c15ull), 0xe220a8397b1dcdafull);
  EXPECT_EQ(mix64(2 * 0x9e3779b97f4a7c15ull), 0x6e789e6aa1b965f4ull);
  EXPECT_EQ(mix64(3 * 0x9e3779b97f4a7c15ull), 0x06c45d188009454full);
}

TEST(HashKey, TellsAddressesAndTheirOrderApart) {
  std::set<std::uint64_t> keys;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    for (std::uint64_t address = 0; address < 100; ++address) keys.insert(hashKey(seed, address));
  }
  EXPECT_EQ(keys.size(), 10'000u);
}

// One flipped bit of the input flips each bit of the output half of the time. Bound: 5 standard deviations.
TEST(Mix32, Avalanches) {
  constexpr int kTrials = 10'000;
  std::array<int, 32> flips{};
  for (std::uint32_t i = 0; i < kTrials; ++i) {
    const std::uint32_t changed = mix32(i) ^ mix32(i ^ (1u << i % 32));
    for (int bit = 0; bit < 32; ++bit) flips[bit] += changed >> bit & 1;
  }
  for (const int count : flips) EXPECT_NEAR(count, kTrials / 2, 5 * std::sqrt(kTrials / 4.0));
}

TEST(ToUnit, StaysBelowOne) {
  EXPECT_EQ(toUnit(0u), 0.f);
  EXPECT_LT(toUnit(~std::uint32_t{0}), 1.f);
  EXPECT_LT(toUnit(~std::uint64_t{0}), 1.f);
  EXPECT_EQ(toUnit(0x80000000u), 0.5f);
}

// Chi-squared with 99 degrees of freedom over equal bins of consecutive addresses: mean 99, sigma 14.1.
// Bound: 5 sigma.
TEST(ToUnit, IsUniformOverAddresses) {
  constexpr int kBins = 100, kDraws = 100'000;
  std::array<int, kBins> bins{};
  for (std::uint64_t i = 0; i < kDraws; ++i) ++bins[static_cast<int>(toUnit(hashKey(7, i)) * kBins)];
  double chi2 = 0;
  const double expected = kDraws / kBins;
  for (const int count : bins) chi2 += (count - expected) * (count - expected) / expected;
  EXPECT_LT(chi2, 99 + 5 * 14.1);
  EXPECT_GT(chi2, 99 - 5 * 14.1);
}

}  // namespace
}  // namespace saccade
