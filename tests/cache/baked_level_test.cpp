#include "cache/baked_level.h"

#include <gtest/gtest.h>

namespace saccade {
namespace {

VertexKey keyAt(VertexKey x, VertexKey y, VertexKey z) {
  return x | y << 20 | z << 40 | VertexKey{3} << 60;
}

const BakedVertex* find(const BakedLevel& level, VertexKey key) {
  return level.find({key, key, key, key})[3];
}

// Every second vertex of a region that spans blocks.
TEST(BakedLevel, FindsEachOfItsVerticesAndNoOther) {
  std::vector<VertexKey> keys;
  std::vector<BakedVertex> light;
  const auto each = [](const auto& f) {
    for (VertexKey x = 9; x > 0; --x)
      for (VertexKey y = 5; y < 14; ++y)
        for (VertexKey z = 7; z < 16; ++z) f(keyAt(x, y, z), (x + y + z) % 2 == 0);
  };
  each([&](VertexKey key, bool held) {
    if (!held) return;
    light.push_back({.rest = static_cast<float>(keys.size())});
    keys.push_back(key);
  });
  const BakedLevel level(keys, light);
  EXPECT_EQ(level.vertices(), keys.size());
  float next = 0;
  each([&](VertexKey key, bool held) {
    const BakedVertex* found = find(level, key);
    ASSERT_EQ(found != nullptr, held);
    if (held) {
      ASSERT_EQ(found->rest, next++);
    }
  });
}

TEST(BakedLevel, MayBeEmpty) {
  EXPECT_EQ(find(BakedLevel(), keyAt(1, 2, 3)), nullptr);
}

}  // namespace
}  // namespace saccade
