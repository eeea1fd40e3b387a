#include "cache/vertex_table.h"

#include <gtest/gtest.h>

#include "base/hash_rng.h"

namespace saccade {
namespace {

TEST(VertexTable, GivesEachKeyOneIndexInTheOrderOfTheirFirstUse) {
  VertexTable table;
  constexpr std::uint32_t kKeys = 5000;  // grows several times
  for (std::uint32_t i = 0; i < kKeys; ++i) {
    EXPECT_EQ(table.findOrAdd(mix64(i + 1)), i);
    EXPECT_EQ(table.findOrAdd(mix64(i / 2 + 1)), i / 2);
  }
  EXPECT_EQ(table.size(), kKeys);
  for (std::uint32_t i = 0; i < kKeys; ++i) ASSERT_EQ(table.findOrAdd(mix64(i + 1)), i);
}

// Keys of vertices are far from random: rows of consecutive numbers.
TEST(VertexTable, KeysInARowHaveIndicesOfTheirOwn) {
  VertexTable table;
  for (std::uint64_t key = 1; key <= 3000; ++key) ASSERT_EQ(table.findOrAdd(key << 40), key - 1);
}

}  // namespace
}  // namespace saccade
