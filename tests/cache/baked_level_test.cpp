#include "cache/bake/baked_level.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace saccade {
namespace {

VertexKey keyAt(VertexKey x, VertexKey y, VertexKey z) {
  return x | y << vertex_bits::kY | z << vertex_bits::kZ | VertexKey{3} << vertex_bits::kBin;
}

// The number of a vertex' light at each corner of a tetrahedron; -1 where there is no vertex.
[[gnu::noinline]] std::array<float, 4> find(const BakedLevel& level, VertexKey lowest, unsigned order) {
  std::array<float, 4> light;
  const auto found = level.find(level.locate(lowest), order);
  for (int c = 0; c < 4; ++c)
    light[c] = found[c] == BakedLevel::kNothing ? -1 : level[found[c]].fine().residual;
  return light;
}

// Every second vertex of a region that spans blocks.
TEST(BakedLevel, FindsEachOfItsVerticesAndNoOther) {
  std::vector<VertexKey> keys;
  const auto each = [](const auto& f) {
    for (VertexKey x = 9; x > 0; --x)
      for (VertexKey y = 5; y < 14; ++y)
        for (VertexKey z = 7; z < 16; ++z) f(keyAt(x, y, z), (x + y + z) % 2 == 0);
  };
  each([&](VertexKey key, bool held) {
    if (!held) return;
    keys.push_back(key);
  });
  std::vector<BakedPair> light(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i)
    light[i] = {{.known = true, .residual = static_cast<float>(i)}, {}};
  const BakedLevel level(keys, light);
  EXPECT_EQ(level.vertices(), keys.size());
  const auto expected = [&](VertexKey key) {
    const auto at = std::find(keys.begin(), keys.end(), key);
    return at == keys.end() ? -1.f : static_cast<float>(at - keys.begin());
  };
  each([&](VertexKey lowest, bool) {
    for (unsigned order = 0; order < 8; ++order) {
      const auto found = find(level, lowest, order);
      const auto corners = Tetrahedron::corners(lowest, order);
      for (int c = 0; c < 4; ++c) ASSERT_EQ(found[c], expected(corners[c])) << order << " " << c;
    }
  });
}

// Two neighbours, at the coordinates -1 and 0 of x.
TEST(BakedLevel, TellsItsLightAtFinerVertices) {
  constexpr VertexKey kZero = Tetrahedron::kCentre;
  const auto vertex = [](float residual) {
    return BakedPair({.known = true, .residual = residual, .var_residual = 2 * residual}, {});
  };
  const BakedLevel level({keyAt(kZero - 1, kZero, kZero), keyAt(kZero, kZero, kZero)},
                         {vertex(2), vertex(6)});
  const auto at = [&](VertexKey x, VertexKey y) { return level.between(keyAt(kZero + x, kZero + y, kZero)); };
  EXPECT_EQ(at(-2, 0).residual, 2);
  EXPECT_EQ(at(-1, 0).residual, 4);
  EXPECT_EQ(at(-1, 0).var_residual, 8);
  EXPECT_EQ(at(0, 0).residual, 6);
  EXPECT_TRUE(at(0, 0).known);
  for (const VertexKey x : {-3, 1}) EXPECT_FALSE(at(x, 0).known);
  EXPECT_FALSE(at(0, 1).known);
}

// A vertex within a block, and one in a block far away. The block of the first one tells of a shadow.
TEST(BakedLevel, KeepsShadowsOfFewBlocks) {
  constexpr VertexKey kZero = Tetrahedron::kCentre;
  const VertexKey edge = keyAt(kZero + 1, kZero + 1, kZero + 1), far = keyAt(kZero + 9, kZero, kZero);
  const BakedPair known({.known = true}, {});
  const BakedLevel level({edge, far}, {known, known}, {0.125f, 0});
  EXPECT_EQ(level.shadowAt(edge), 0.125f);
  EXPECT_EQ(level.shadowAt(far), 0);
  EXPECT_TRUE(level.isNearShadow(level.locate(keyAt(kZero + 3, kZero, kZero))));
  EXPECT_FALSE(level.isNearShadow(level.locate(far)));
  EXPECT_EQ(level.between(keyAt(kZero + 2, kZero + 2, kZero + 2)).shadow, 0.125f);
  EXPECT_FALSE(BakedLevel({edge}, {known}, {0}).hasShadows());
}

TEST(BakedLevel, MayBeEmpty) {
  EXPECT_EQ(find(BakedLevel(), keyAt(1, 2, 3), 0), (std::array<float, 4>{-1, -1, -1, -1}));
}

}  // namespace
}  // namespace saccade
