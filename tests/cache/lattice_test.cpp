#include "cache/lattice/lattice.h"

#include <gtest/gtest.h>

#include <map>

#include "base/hash_rng.h"

namespace saccade {
namespace {

double random(std::uint64_t i) {
  return toUnit(mix64(i + 1));
}

Vec3d randomPoint(std::uint64_t i) {
  return Vec3d{random(3 * i) - 0.5, random(3 * i + 1) - 0.5, random(3 * i + 2) - 0.5} * 20.0;
}

// The weights of two points by key.
double largestDifference(const Tetrahedron& a, const Tetrahedron& b) {
  std::map<VertexKey, double> weights;
  for (int i = 0; i < 4; ++i) weights[a.key[i]] += a.weight[i], weights[b.key[i]] -= b.weight[i];
  double largest = 0;
  for (const auto& [key, weight] : weights) largest = std::max(largest, std::abs(weight));
  return largest;
}

TEST(Tetrahedron, WeightsAreNotNegativeAndSumToOne) {
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const Tetrahedron t(randomPoint(i), 0);
    float sum = 0;
    for (const float w : t.weight) {
      EXPECT_GE(w, 0);
      sum += w;
    }
    EXPECT_NEAR(sum, 1, 1e-6);
  }
}

// Each corner's key moves by a fixed amount along an axis, which tells its place.
TEST(Tetrahedron, ReproducesALinearFunction) {
  const VertexKey origin = Tetrahedron({0, 0, 0}, 0).key[0];
  const auto place = [&](VertexKey key) {
    const auto part = [&](int shift) {
      const auto of = [&](VertexKey k) {
        return static_cast<double>(k >> shift & Tetrahedron::kAddressMask);
      };
      return of(key) - of(origin);
    };
    return Vec3d{part(vertex_bits::kX), part(vertex_bits::kY), part(vertex_bits::kZ)};
  };
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const Vec3d q = randomPoint(i), slope{1, -2, 3};
    const Tetrahedron t(q, 0);
    double value = 0;
    for (int c = 0; c < 4; ++c) value += t.weight[c] * dot(slope, place(t.key[c]));
    EXPECT_NEAR(value, dot(slope, q), 1e-4);
  }
}

// A step in the weights would be a false event on a moving picture.
TEST(Tetrahedron, WeightsAreContinuous) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Vec3d from = randomPoint(i), way = randomPoint(i + 1000) * 0.1;
    constexpr int kSteps = 1000;
    const double longest = std::sqrt(dot(way, way)) / kSteps;
    for (int k = 0; k < kSteps; ++k) {
      const Tetrahedron a(from + way * (k / double{kSteps}), 0),
          b(from + way * ((k + 1) / double{kSteps}), 0);
      ASSERT_LE(largestDifference(a, b), 2 * longest + 1e-5);
    }
  }
}

TEST(Tetrahedron, BinsShareNoVertex) {
  for (int bin = 1; bin < 12; ++bin)
    EXPECT_EQ(largestDifference(Tetrahedron({0.2, 0.3, 0.4}, 0), Tetrahedron({0.2, 0.3, 0.4}, bin)),
              largestDifference(Tetrahedron({0.2, 0.3, 0.4}, 0), Tetrahedron({9.2, 0.3, 0.4}, 0)));
}

TEST(NormalBins, AnAxisHasOneBinAndItsOppositeAnother) {
  const NormalBins up({0, 1, 0}), down({0, -1, 0});
  ASSERT_EQ(up.count, 1);
  ASSERT_EQ(down.count, 1);
  EXPECT_NE(up.bin[0], down.bin[0]);
  EXPECT_EQ(up.weight[0], 1);
}

TEST(NormalBins, WeightsSumToOneAndAreContinuous) {
  const auto weights = [](double angle, double height) {
    const NormalBins n(normalize(Vec3{static_cast<float>(std::cos(angle)),
                                      static_cast<float>(std::sin(angle)), static_cast<float>(height)}));
    std::array<float, 6> w{};
    for (int i = 0; i < n.count; ++i) w[n.bin[i]] = n.weight[i];
    return w;
  };
  for (const double height : {0.0, 0.3, 1.0, -2.0}) {
    for (int k = 0; k < 2000; ++k) {
      const auto a = weights(k * 0.00314, height), b = weights((k + 1) * 0.00314, height);
      float sum = 0;
      for (int i = 0; i < 6; ++i) {
        ASSERT_NEAR(a[i], b[i], 0.03);
        sum += a[i];
      }
      ASSERT_NEAR(sum, 1, 1e-5);
    }
  }
}

}  // namespace
}  // namespace saccade
