// Lanes against plain loops. The 16 lanes of AVX-512 are tested through render/paths.
#include "base/wide.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/turn.h"

namespace saccade {
namespace {

TEST(Wide, MasksAndBitsAreTheSame) {
  for (std::uint32_t bits = 0; bits < 256; ++bits) EXPECT_EQ(lanesOf(maskOf<8>({bits})).bits, bits);
  for (int count = 0; count <= 8; ++count) EXPECT_EQ(lanesOf(firstLanes<8>(count)), LaneSet::first(count));
}

TEST(Wide, CompressMovesTheLanesOfAMaskTogether) {
  const Floats<8> v([](auto lane) { return 10.f + static_cast<float>(lane); });
  for (std::uint32_t bits = 0; bits < 256; ++bits) {
    float out[8] = {};
    compress({bits}, v, out);
    int next = 0;
    for (int lane = 0; lane < 8; ++lane) {
      if (!(bits >> lane & 1)) continue;
      EXPECT_EQ(out[next++], 10.f + static_cast<float>(lane)) << bits;
    }
  }
}

TEST(Wide, GatherTakesTheElementOfEachLane) {
  std::array<float, 100> values;
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i);
  const Uints<8> index = laneNumbers<8>() * 13u;
  const Floats<8> v = gather(values.data(), index);
  for (std::size_t lane = 0; lane < 8; ++lane) EXPECT_EQ(v[lane], 13.f * static_cast<float>(lane));
}

TEST(Wide, ForEachLaneGoesFromTheFirstToTheLast) {
  std::vector<int> lanes;
  forEachLane({0b10010110u}, [&](int i) { lanes.push_back(i); });
  EXPECT_EQ(lanes, (std::vector{1, 2, 4, 7}));
}

TEST(Turn, SineAndCosineOfPartsOfATurn) {
  for (int i = 0; i <= 10000; ++i) {
    const float u = static_cast<float>(i) / 10000;
    const auto [sine, cosine] = sinCosOfTurn(u);
    EXPECT_NEAR(sine, std::sin(2 * std::numbers::pi * u), 4e-7) << u;
    EXPECT_NEAR(cosine, std::cos(2 * std::numbers::pi * u), 4e-7) << u;
    EXPECT_NEAR(sinCosOfTurn(Floats<8>(u)).sin[3], sine, 1e-6) << u;
  }
}

}  // namespace
}  // namespace saccade
