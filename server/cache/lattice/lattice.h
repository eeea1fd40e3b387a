// Where a surface point lies in the grid: the vertices around it on one level, with their weights.
//
// Within a level the cells are cubes of edge 2^level scene units. Each is cut into six tetrahedra by the
// order of the coordinates within it (Kuhn 1960). Weights are linear within a tetrahedron, continuous, and
// sum to 1. Normals fall into six bins, one for each direction of an axis, with weights that are continuous
// in the normal.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "base/vec.h"

namespace saccade {

// Address of a vertex in its level: 19 bits for each coordinate, 6 for the bin. Vertices 2^19 cells apart
// share an address; cells are so small only near the camera, and what is so far away has larger ones.
using VertexKey = std::uint64_t;

namespace vertex_bits {
inline constexpr int kCoordinate = 19;  // of each coordinate, and where they begin:
inline constexpr int kX = 0, kY = kX + kCoordinate, kZ = kY + kCoordinate, kBin = kZ + kCoordinate;
}  // namespace vertex_bits

// 2^exponent, from -126 to 127.
inline float powerOfTwo(int exponent) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(127 + exponent) << 23);
}

// The tetrahedron around a point, q = point / edge of a cell: keys and weights of its corners.
struct Tetrahedron {
  Tetrahedron(Vec3d q, int bin) {
    const Vec3d low{std::floor(q.x), std::floor(q.y), std::floor(q.z)};
    const auto x = static_cast<float>(q.x - low.x), y = static_cast<float>(q.y - low.y),
               z = static_cast<float>(q.z - low.z);
    // From the lowest corner to the highest, along the axis of the largest fraction first.
    const unsigned order = unsigned(x >= y) | unsigned(x >= z) << 1 | unsigned(y >= z) << 2;
    const float a = std::max({x, y, z}), c = std::min({x, y, z}),
                b = std::max(std::min(x, y), std::min(std::max(x, y), z));
    const auto whole = [](double c) { return static_cast<std::int64_t>(c); };
    key = corners(lowest(address(whole(low.x)), address(whole(low.y)), address(whole(low.z)), bin), order);
    weight = {1 - a, a - b, b - c, c};
  }

  // The key of the lowest corner, from the addresses of its coordinates.
  static VertexKey lowest(VertexKey x, VertexKey y, VertexKey z, int bin) {
    using namespace vertex_bits;
    return x << kX | y << kY | z << kZ | static_cast<VertexKey>(bin + 1) << kBin;
  }
  // Addresses of whole numbers c: (c + kCentre) & kAddressMask. Centred, so that no coordinate near 0
  // overflows into the next one.
  static constexpr std::int32_t kCentre = 1 << (vertex_bits::kCoordinate - 1),
                                kAddressMask = (1 << vertex_bits::kCoordinate) - 1;
  // The keys of all corners. `order`: a bit each for x >= y, x >= z, y >= z of the fractions.
  static std::array<VertexKey, 4> corners(VertexKey lowest, unsigned order) {
    const auto [most, least] = axes(order);
    return {lowest, lowest + kSteps[most], lowest + kSteps[0] + kSteps[1] + kSteps[2] - kSteps[least],
            lowest + kSteps[0] + kSteps[1] + kSteps[2]};
  }
  // The axes, 0 to 2, of the largest and of the smallest fraction.
  struct Axes {
    std::uint8_t most, least;
  };
  static Axes axes(unsigned order) { return kOrders[order]; }

  std::array<VertexKey, 4> key;
  std::array<float, 4> weight;

  // Where the vertex of a key is, of those that share it the one nearest to the origin; and its bin.
  static Vec3d placeOf(VertexKey key) {
    using namespace vertex_bits;
    return {coordinate(key >> kX), coordinate(key >> kY), coordinate(key >> kZ)};
  }
  static int binOf(VertexKey key) { return static_cast<int>(key >> vertex_bits::kBin) - 1; }

 private:
  static constexpr std::array<VertexKey, 3> kSteps{
      VertexKey{1} << vertex_bits::kX, VertexKey{1} << vertex_bits::kY, VertexKey{1} << vertex_bits::kZ};
  // A table, because no processor can guess the order.
  static constexpr auto kOrders = [] {
    std::array<Axes, 8> orders{};
    for (unsigned i = 0; i < 8; ++i) {
      const bool xy = i & 1, xz = i & 2, yz = i & 4;
      const int most = xy && xz ? 0 : !xy && yz ? 1 : 2, least = xz && yz ? 2 : xy && !yz ? 1 : 0;
      orders[i] = {static_cast<std::uint8_t>(most), static_cast<std::uint8_t>(least)};
    }
    return orders;
  }();
  static VertexKey address(std::int64_t c) { return static_cast<VertexKey>((c + kCentre) & kAddressMask); }
  static double coordinate(VertexKey address) {
    return static_cast<double>((static_cast<std::int64_t>(address) & kAddressMask) - kCentre);
  }
};

// The bins of a unit normal: axis 0, 1 or 2, plus 3 where it points to the negative side.
struct NormalBins {
  NormalBins() = default;
  explicit NormalBins(Vec3 n) {
    const std::array<float, 3> v{n.x, n.y, n.z};
    std::array<float, 3> w;
    float all = 0, sum = 0;
    for (int k = 0; k < 3; ++k) all += w[k] = v[k] * v[k] * v[k] * v[k];
    for (float& share : w) sum += share = std::max(0.f, share / all - kLeastShare);
    for (int k = 0; k < 3; ++k)
      if (w[k] > 0) bin[count] = k + (v[k] < 0 ? 3 : 0), weight[count++] = w[k] / sum;
  }

  static constexpr float kLeastShare = 0.03f;  // bins with less do not count
  int count = 0;
  std::array<int, 3> bin;
  std::array<float, 3> weight;
};

}  // namespace saccade
