#include "cache/lattice/index_table.h"

#include <gtest/gtest.h>

#include "base/hash_rng.h"

namespace saccade {
namespace {

TEST(IndexTable, GivesEachKeyOneIndexInTheOrderOfTheirFirstUse) {
  IndexTable table;
  constexpr std::uint32_t kKeys = 5000;  // grows several times
  for (std::uint32_t i = 0; i < kKeys; ++i) {
    EXPECT_EQ(table.findOrAdd(mix64(i + 1), 0), i);
    EXPECT_EQ(table.findOrAdd(mix64(i / 2 + 1), 0), i / 2);
  }
  EXPECT_EQ(table.size(), kKeys);
  for (std::uint32_t i = 0; i < kKeys; ++i) ASSERT_EQ(table.findOrAdd(mix64(i + 1), 0), i);
}

// Keys of vertices are far from random: rows of consecutive numbers.
TEST(IndexTable, KeysInARowHaveIndicesOfTheirOwn) {
  IndexTable table;
  for (std::uint64_t key = 1; key <= 3000; ++key) ASSERT_EQ(table.findOrAdd(key << 40, 0), key - 1);
}

TEST(IndexTable, KeepsWhatItIsToldToInItsOrder) {
  IndexTable table;
  for (std::uint64_t key = 1; key <= 100; ++key) table.findOrAdd(key, static_cast<std::uint32_t>(key % 3));
  const std::vector<std::uint32_t> uses = table.lastUses();
  std::vector<bool> kept;
  for (const std::uint32_t used : uses) kept.push_back(used == 1);
  table.keep(kept);
  EXPECT_EQ(table.size(), 34u);  // 1, 4, 7, ... 100
  for (std::uint32_t i = 0; i < 34; ++i) EXPECT_EQ(table.findOrAdd(3 * i + 1, 5), i);
  EXPECT_EQ(table.findOrAdd(2, 5), 34u);
  EXPECT_EQ(table.lastUses(), std::vector<std::uint32_t>(35, 5));
}

}  // namespace
}  // namespace saccade
