#include "cache/grid/vertex_table.h"

#include <gtest/gtest.h>

#include "base/hash_rng.h"

namespace saccade {
namespace {

std::uint32_t indexOf(VertexTable& table, VertexKey key, std::uint32_t now = 0) {
  return table.indexAt(VertexTable::Finder(table, now).find(key));
}

VertexKey keyAt(VertexKey x, VertexKey y, VertexKey z, VertexKey bin = 1) {
  return x | y << vertex_bits::kY | z << vertex_bits::kZ | bin << vertex_bits::kBin;
}

TEST(VertexTable, GivesEachKeyOneIndexInTheOrderOfTheirFirstUse) {
  VertexTable table;
  VertexTable::Finder finder(table, 0);
  const auto key = [](std::uint64_t i) { return mix64(i) >> 2 | VertexKey{1} << 60; };
  constexpr std::uint32_t kKeys = 5000;  // grows several times
  for (std::uint32_t i = 0; i < kKeys; ++i) {
    ASSERT_EQ(table.indexAt(finder.find(key(i))), i);
    ASSERT_EQ(table.indexAt(finder.find(key(i / 2))), i / 2);
  }
  EXPECT_EQ(table.size(), kKeys);
}

// All vertices of a region, of two bins, so that blocks meet at all their sides.
TEST(VertexTable, NeighboursHaveIndicesOfTheirOwn) {
  VertexTable table;
  VertexTable::Finder finder(table, 0);
  for (int round = 0; round < 2; ++round) {
    std::uint32_t next = 0;
    for (VertexKey x = 100; x < 120; ++x)
      for (VertexKey y = 50; y < 60; ++y)
        for (VertexKey z = 1; z < 12; ++z)
          for (VertexKey bin = 1; bin <= 12; bin += 11)
            ASSERT_EQ(table.indexAt(finder.find(keyAt(x, y, z, bin))), next++);
  }
}

TEST(VertexTable, KeepsWhatItIsToldToInItsOrder) {
  VertexTable table;
  for (VertexKey block = 0; block < 9; ++block)
    for (VertexKey x = 0; x < 2; ++x) indexOf(table, keyAt(4 * block + x, 0, 0), block % 3);
  const std::vector<std::uint32_t> uses = table.lastUses();
  ASSERT_EQ(uses.size(), 18u);
  std::vector<bool> kept;
  for (const std::uint32_t used : uses) kept.push_back(used == 1);
  table.keep(kept);
  EXPECT_EQ(table.size(), 6u);  // blocks 1, 4 and 7
  for (VertexKey i = 0; i < 3; ++i)
    for (VertexKey x = 0; x < 2; ++x)
      EXPECT_EQ(indexOf(table, keyAt(4 * (3 * i + 1) + x, 0, 0), 5), 2 * i + x);
  EXPECT_EQ(indexOf(table, keyAt(0, 0, 0), 5), 6u);
  EXPECT_EQ(table.lastUses(), std::vector<std::uint32_t>(7, 5));
}

TEST(VertexTable, TellsTheKeysOfItsVertices) {
  VertexTable table;
  std::vector<VertexKey> keys;
  for (VertexKey i = 0; i < 300; ++i) {
    keys.push_back(keyAt(100 + i % 7, 50 + i / 7 % 6, 1 + i / 42, 12));
    indexOf(table, keys.back());
  }
  EXPECT_EQ(table.keys(), keys);
}

TEST(VertexTable, AReaderAddsNothing) {
  VertexTable table;
  indexOf(table, keyAt(4, 4, 4));
  indexOf(table, keyAt(5, 4, 4));
  VertexTable::Reader reader(table);
  EXPECT_EQ(reader.indexOf(keyAt(5, 4, 4)), 1u);
  EXPECT_EQ(reader.indexOf(keyAt(6, 4, 4)), VertexTable::kNone);    // of the same block
  EXPECT_EQ(reader.indexOf(keyAt(400, 4, 4)), VertexTable::kNone);  // of none
  EXPECT_EQ(table.size(), 2u);
}

}  // namespace
}  // namespace saccade
