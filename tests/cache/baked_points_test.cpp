#include "cache/bake/baked_points.h"

#include <gtest/gtest.h>

#include "base/hash_rng.h"

namespace saccade {
namespace {

constexpr int kFinest = -3;  // exponent of the edge of the finest cells
constexpr int kReach = 9;    // of the vertices around the origin, cells of their level

struct BakedPointsTest : testing::Test {
  BakedPointsTest() {
    levels.first = kFinest;
    levels.levels.resize(2);
    for (const int i : {1, 0}) levels.levels[i] = makeLevel(levels.at(kFinest + i + 1), i == 0);
  }
  float random() { return toUnit(hashKey(1, ++drawn)); }

  // Light differs at all vertices. With `gaps` some do not know it, and some are not there.
  BakedLevel makeLevel(const BakedLevel& coarser, bool gaps) {
    std::vector<VertexKey> keys;
    std::vector<BakedPair> light;
    std::vector<float> shadows;
    for (int x = -kReach; x <= kReach; ++x)
      for (int y = -kReach; y <= kReach; ++y)
        for (int z = -kReach; z <= kReach; ++z)
          for (int bin = 0; bin < kVertexBins; ++bin) {
            const float draw = gaps ? random() : 1;
            if (draw < 0.05f) continue;
            keys.push_back(Tetrahedron({double(x), double(y), double(z)}, bin).key[0]);
            const BakedVertex fine{true, random(), random(), random(), random(), random(), random()};
            light.push_back({draw < 0.1f ? BakedVertex{} : fine, coarser.between(keys.back())});
            shadows.push_back(x > 0 ? random() : 0);
          }
    return {keys, light, shadows};
  }

  BakedLevels levels;
  std::uint64_t drawn = 0;
};

// The light of a level around a point, and the share of the weights on known vertices.
struct Known {
  float residual = 0, var_residual = 0, share = 0;
};
Known readLevel(const BakedLevels& levels, int exponent, const SurfacePlace& place, SurfaceKind kind) {
  const NormalBins bins(place.normal);
  Known sum;
  for (int b = 0; b < bins.count; ++b) {
    const Tetrahedron corners(toDouble(place.position) * std::ldexp(1.0, -exponent),
                              vertexBin(bins.bin[b], kind));
    for (int c = 0; c < 4; ++c) {
      const BakedVertex light = levels.at(exponent).at(corners.key[c]).fine();
      const float w = corners.weight[c] * bins.weight[b];
      sum.residual += light.residual * w, sum.var_residual += light.var_residual * w;
      if (light.known) sum.share += w;
    }
  }
  return sum;
}

// That of the finer level is told, but for gaps, and where there is no such level.
TEST_F(BakedPointsTest, ReadShadowsOfTheFinerLevel) {
  constexpr float kRounding = 1e-6f;
  int near = 0;
  for (int batch = 0; batch < 200; ++batch) {
    BakedPoints points;
    const auto coordinate = [&] { return 1.8f * random() - 0.9f; };
    const SurfacePlace place{{coordinate(), coordinate(), coordinate()}, {0, 0, 1}, 0.125f * (1 + random())};
    points.add({}, place, SurfaceKind::kDiffuse);
    points.want(levels, 1);
    points.locate();
    points.find();
    const Tetrahedron corners(toDouble(place.position) * std::ldexp(1.0, -kFinest),
                              vertexBin(NormalBins(place.normal).bin[0], SurfaceKind::kDiffuse));
    float expected = 0;
    const BakedLevel& fine = levels.at(kFinest);
    const auto isMissing = [&](VertexKey key) { return !fine.at(key).coarse().known; };
    if (std::ranges::any_of(corners.key, isMissing)) continue;
    for (int c = 0; c < 4; ++c) expected += fine.shadowAt(corners.key[c]) * corners.weight[c];
    near += expected > kRounding;
    ASSERT_NEAR(points.shadows()[0], expected, kRounding) << batch;
    if (expected > kRounding) {
      ASSERT_TRUE(points.anyNearShadow()) << batch;
    }
  }
  EXPECT_GT(near, 20);
}

// Batches are full or not. Some points lie outside the fine level, or outside both.
TEST_F(BakedPointsTest, ReadTwoLevelsAsIfEachWereReadByItself) {
  for (int batch = 0; batch < 200; ++batch) {
    BakedPoints points;
    std::vector<SurfacePlace> places;
    const SurfaceKind kind = batch % 2 == 0 ? SurfaceKind::kDiffuse : SurfaceKind::kMixed;
    for (int i = 0; i < 1 + batch % BakedPoints::kMost; ++i) {
      const auto coordinate = [&] { return 2.4f * random() - 1.2f; };
      const Vec3 normal = normalize(Vec3{coordinate(), coordinate(), coordinate()});
      places.push_back({{coordinate(), coordinate(), coordinate()}, normal, 0.125f * (1 + random())});
      points.add({}, places.back(), kind);
    }
    points.want(levels, 1);
    points.locate();
    points.find();
    const auto [means, variances] = points.light();
    for (std::size_t i = 0; i < places.size(); ++i)
      for (const int slot : {0, 1}) {
        const Known expected = readLevel(levels, kFinest + slot, places[i], kind);
        const int lane = slot * kOfCoarse;
        ASSERT_NEAR(means[lane + kKnown][i], expected.share, 1e-4f) << batch << " " << i << " " << slot;
        ASSERT_NEAR(means[lane + kResidual][i], expected.residual, 3e-4f) << batch << " " << i << " " << slot;
        ASSERT_NEAR(variances[lane + kVarResidual][i], expected.var_residual, 0.07f);
      }
  }
}

}  // namespace
}  // namespace saccade
