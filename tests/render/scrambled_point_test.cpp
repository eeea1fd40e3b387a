#include "render/sampling/scrambled_point.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "render/sampling/path_numbers.h"

namespace saccade {
namespace {

using Point = ScrambledPoint<std::uint32_t>;

// The points of 2^m indices from `first` on.
std::vector<Point> block(std::uint32_t key, std::uint32_t first, int m) {
  std::vector<Point> points;
  for (std::uint32_t i = 0; i < 1u << m; ++i) points.emplace_back(reverseBits(first + i), key);
  return points;
}

// The most points in any of the boxes whose edges are 2^-bits of each coordinate.
int mostInABox(const std::vector<Point>& points, const std::array<int, kPointCoordinates>& bits) {
  std::vector<int> in(std::size_t{1} << (bits[0] + bits[1] + bits[2]));
  for (const Point& p : points) {
    std::uint64_t box = 0;
    for (std::uint32_t c = 0; c < kPointCoordinates; ++c)
      box = box << bits[c] | std::uint64_t{p.at(c)} >> (32 - bits[c]);
    ++in[box];
  }
  return *std::ranges::max_element(in);
}

// Calls f(key, first index, m) for some blocks.
void forEachBlock(const auto& f) {
  for (const std::uint32_t key : {0u, 1u, 0xdeadbeefu, 0x12345678u})
    for (const std::uint32_t block : {0u, 1u, 77u, 12345u})
      for (int m = 1; m <= 10; ++m) f(key, block << m, m);
}

// Niederreiter 1988: a (t, m, s)-net has 2^t points in each box of volume 2^(t - m). Here t is the sum of the
// degrees of the bases less 1.
TEST(ScrambledPoint, FirstTwoCoordinatesAreNetsWithOnePointInEachBox) {
  forEachBlock([](std::uint32_t key, std::uint32_t first, int m) {
    const auto points = block(key, first, m);
    for (int a = 0; a <= m; ++a)
      EXPECT_EQ(mostInABox(points, {a, m - a, 0}), 1) << key << ' ' << first << ' ' << m << ' ' << a;
  });
}

TEST(ScrambledPoint, AllCoordinatesAreNetsWithTwoPointsInEachBox) {
  forEachBlock([](std::uint32_t key, std::uint32_t first, int m) {
    const auto points = block(key, first, m);
    for (int a = 0; a < m; ++a)
      for (int b = 0; a + b < m; ++b)
        EXPECT_EQ(mostInABox(points, {a, b, m - 1 - a - b}), 2) << key << ' ' << first << ' ' << m;
  });
}

// A digit of a base is the remainder of a division by it: Horner's rule gives the polynomial back.
TEST(NetDigits, AreThoseOfTheIndexAsAPolynomial) {
  const auto times = [](std::uint64_t a, std::uint64_t b) {
    std::uint64_t product = 0;
    for (int k = 0; k < 3; ++k) product ^= (b >> k & 1) * (a << k);
    return product;
  };
  const auto value = [&](std::uint32_t digits, int bits, std::uint64_t base) {
    std::uint64_t sum = 0;
    for (int first = 32 - bits; first >= 0; first -= bits)
      sum = times(sum, base) ^ (digits >> first & ((1u << bits) - 1));
    return sum;
  };
  for (const std::uint32_t n : {0u, 1u, 2u, 5u, 0x80000000u, 0xcafebabeu, 0xffffffffu}) {
    EXPECT_EQ(value(digitsInXPlus1(n), 1, 0b11), n);
    EXPECT_EQ(value(digitsInX2PlusXPlus1(n), 2, 0b111), n);
  }
}

TEST(PathNumbers, LanesHaveTheNumbersOfTheirPaths) {
  constexpr int kW = 8;
  const PathNumbers<kW> numbers{mix32(laneNumbers<kW>()), mix32(Uints<kW>(laneNumbers<kW>() + 99u))};
  for (std::uint32_t group = 0; group < 5; ++group)
    for (std::uint32_t k = 0; k < PathSampler::kGroup; ++k) {
      const std::uint32_t first = group * PathSampler::kGroup;
      const auto u = PathNumbers<kW>::unit(numbers.point(first).at(k));
      for (std::size_t lane = 0; lane < kW; ++lane)
        EXPECT_EQ(u[lane], PathSampler(numbers.reversed_index[lane], numbers.key[lane]).u(first + k));
    }
}

}  // namespace
}  // namespace saccade
