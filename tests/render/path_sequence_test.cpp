#include "render/paths/path_sequence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace saccade {
namespace {

constexpr int kW = 8;

float numberOf(const PathSampler& path, Dimension d) {
  return sequenceNumbers<kW>({Uints<kW>(path.reversed_index), Uints<kW>(path.key)}, d)[0];
}

// The mean of f over the paths of a square of pixels in some frames, with a path for each.
double meanOver(std::uint64_t stream, std::uint32_t edge, std::uint64_t frames, const auto& f) {
  double sum = 0;
  for (std::uint64_t t = 0; t < frames; ++t) {
    const SequencePlace places(stream, t);
    for (std::uint32_t y = 0; y < edge; ++y)
      for (std::uint32_t x = 0; x < edge; ++x) sum += f(places.of(x, y, 0));
  }
  return sum / (edge * edge * static_cast<double>(frames));
}

// 1 on one side of an edge through a square of numbers, as of a shadow across a lamp.
auto halfOf(Dimension first, double angle) {
  return [=](const PathSampler& path) {
    const double u = numberOf(path, first) - 0.5, v = numberOf(path, static_cast<Dimension>(first + 1)) - 0.5;
    return u * std::cos(angle) + v * std::sin(angle) < 0 ? 1.0 : 0.0;
  };
}

TEST(PathSequence, EachNumberIsUniform) {
  for (std::uint32_t d = 0; d < kDimensions; ++d) {
    const auto u = [&](const PathSampler& path) { return numberOf(path, static_cast<Dimension>(d)); };
    EXPECT_NEAR(meanOver(7, 16, 64, u), 1. / 2, 0.01) << d;
    EXPECT_NEAR(meanOver(7, 16, 64, [&](const auto& path) { return u(path) * u(path); }), 1. / 3, 0.01) << d;
    const auto any = SequencePlace(7, 0).of(3, 4, 0);
    EXPECT_GE(u(any), 0);
    EXPECT_LT(u(any), 1);
  }
}

// Random numbers would give the variance 1/4 over the number of samples.
TEST(PathSequence, MeansOverNeighboursAndFramesHaveLessNoiseThanRandomOnes) {
  for (const Dimension first : {static_cast<Dimension>(kLight + 1), kBounce})
    for (const auto& [edge, frames] : {std::pair{2u, 4u}, {4u, 1u}, {4u, 4u}}) {
      double variance = 0;
      constexpr int kAngles = 8, kStreams = 60;
      for (int angle = 0; angle < kAngles; ++angle)
        for (int stream = 0; stream < kStreams; ++stream)
          variance += std::pow(meanOver(stream, edge, frames, halfOf(first, angle * 0.39 + 0.1)) - 0.5, 2);
      variance /= kAngles * kStreams;
      const double random = 0.25 / (edge * edge * static_cast<double>(frames));
      EXPECT_LT(variance, 0.85 * random) << edge << ' ' << frames << ' ' << first;
      if (edge * frames >= 8) {
        EXPECT_LT(variance, 0.5 * random) << edge << ' ' << frames << ' ' << first;
      }
    }
}

// A sum over runs has the noise of runs that know nothing of each other.
TEST(PathSequence, RunsOfFramesAreIndependent) {
  double products = 0, squares = 0;
  for (int stream = 0; stream < 400; ++stream) {
    const auto error = [&](std::uint64_t frame) {
      const SequencePlace places(stream, frame);
      return halfOf(kBounce, 0.3)(places.of(5, 6, 0)) - 0.5;
    };
    products += error(0) * error(SequencePlace::kRunFrames), squares += error(0) * error(0);
  }
  EXPECT_LT(std::abs(products), 0.15 * squares);
}

TEST(PathSequence, NoTwoPathsShareTheirNumbers) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> keys;
  std::size_t count = 0;
  for (const std::uint64_t frame : {0, 1, 5})
    for (const std::uint32_t x : {0, 1, 2048, 4096})
      for (const std::uint32_t y : {0, 1, 2048})
        for (const std::uint32_t path : {0, 1, 255, 256, 1024}) {
          const PathSampler at = SequencePlace(1, frame).of(x, y, path);
          keys.insert({at.reversed_index, at.key}), ++count;
        }
  EXPECT_EQ(keys.size(), count);
}

}  // namespace
}  // namespace saccade
