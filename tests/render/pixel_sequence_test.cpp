#include "render/sampling/pixel_sequence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "render/chi_square.h"
#include "render/paths/tracing.h"

namespace saccade {
namespace {

using Kind = NumberKind;

// The mean of f over the samples of a square of pixels.
double meanOver(const PixelSequence& numbers, int edge, int samples, const auto& f) {
  double sum = 0;
  for (int y = 0; y < edge; ++y)
    for (int x = 0; x < edge; ++x)
      for (int i = 0; i < samples; ++i) sum += f(numbers.of(x, y, static_cast<std::uint32_t>(i)));
  return sum / (edge * edge * samples);
}

// The mean square error of such means over many seeds.
double errorOf(Kind kind, int edge, int samples, double truth, const auto& f) {
  constexpr int kSeeds = 400;
  double sum = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed)
    sum += std::pow(meanOver(PixelSequence(seed, samples, kind), edge, samples, f) - truth, 2);
  return sum / kSeeds;
}

const auto product = [](const PathSampler& path) { return double{path.u(kLight)} * path.u(kLight + 1); };
const auto disk = [](const PathSampler& path) {
  return std::hypot(path.u(kBounce), path.u(kBounce + 1)) < 1 ? 1. : 0.;
};
constexpr double kProductVariance = 1. / 9 - 1. / 16, kDisk = std::numbers::pi / 4,
                 kDiskVariance = kDisk * (1 - kDisk);

// Owen 1997: the error of smooth integrands falls with n^-3, of those with edges with n^-3/2.
TEST(PixelSequence, ErrorsFallFasterThanThoseOfRandomNumbers) {
  for (const int n : {16, 64, 256}) {
    EXPECT_LT(errorOf(Kind::kEven, 1, n, 1. / 4, product), 2 * kProductVariance / std::pow(n, 2)) << n;
    EXPECT_LT(errorOf(Kind::kEven, 1, n, kDisk, disk), 2 * kDiskVariance / std::pow(n, 1.5)) << n;
  }
  EXPECT_LT(errorOf(Kind::kEven, 1, 1, 1. / 4, product), 1.3 * kProductVariance);  // as one random number
}

TEST(PixelSequence, NeighboursShareTheirErrorLessThanRandomNumbers) {
  EXPECT_LT(errorOf(Kind::kEven, 4, 1, kDisk, disk), 0.5 * kDiskVariance / 16);
  EXPECT_LT(errorOf(Kind::kEven, 2, 4, kDisk, disk), 0.5 * kDiskVariance / 16);
}

TEST(PixelSequence, IndependentNumbersHaveTheErrorOfRandomOnes) {
  EXPECT_NEAR(errorOf(Kind::kIndependent, 1, 64, 1. / 4, product) * 64 / kProductVariance, 1, 0.25);
  EXPECT_NEAR(errorOf(Kind::kIndependent, 4, 4, kDisk, disk) * 64 / kDiskVariance, 1, 0.25);
}

// One sample of each of many seeds.
test::Histogram histogram(Kind kind, int bins, const auto& bin_of) {
  test::Histogram seen(static_cast<std::size_t>(bins));
  for (std::uint64_t seed = 0; seed < 1 << 14; ++seed)
    ++seen[static_cast<std::size_t>(bin_of(PixelSequence(seed, 4, kind).of(3, 5, 2)))];
  return seen;
}
double score(const test::Histogram& seen) {
  return test::chiSquareScore(
      seen, test::Histogram(seen.size(), double{1 << 14} / static_cast<double>(seen.size())));
}

TEST(PixelSequence, EachNumberIsUniformAndPairsAreIndependent) {
  constexpr std::uint32_t kTried = 2 * kDimensions;
  const double bound = test::kScoreOf1In1000 + 1;  // of the worst of 150
  for (const Kind kind : {Kind::kEven, Kind::kIndependent})
    for (std::uint32_t a = 0; a < kTried; ++a) {
      EXPECT_LT(score(histogram(kind, 64, [&](const auto& path) { return path.u(a) * 64; })), bound) << a;
      for (std::uint32_t b = 0; b < a; ++b)
        EXPECT_LT(
            score(histogram(kind, 64,
                            [&](const auto& path) { return int(path.u(a) * 8) * 8 + int(path.u(b) * 8); })),
            bound)
            << a << ' ' << b;
    }
}

TEST(PixelSequence, AddressesHaveNumbersOfTheirOwn) {
  for (const Kind kind : {Kind::kEven, Kind::kIndependent}) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> keys;
    std::size_t count = 0;
    for (const std::uint64_t seed : {1, 2})
      for (const int x : {0, 1, 2, 40000})
        for (const int y : {0, 1, 2, 65535})
          for (const std::uint32_t i : {0, 1, 1000000}) {
            const PathSampler path = PixelSequence(seed, 1 << 20, kind).of(x, y, i);
            keys.insert({path.reversed_index, path.key}), ++count;
          }
    EXPECT_EQ(keys.size(), count);
  }
}

}  // namespace
}  // namespace saccade
