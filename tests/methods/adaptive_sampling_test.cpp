#include "methods/adaptive_sampling.h"

#include <gtest/gtest.h>

#include <functional>

#include "filter/synthetic.h"

namespace saccade {
namespace {

constexpr int kW = 4, kH = 2, kSpp = 64;
using Light = std::function<float(int x, int round)>;

struct Fixture : ::testing::Test {
  // Returns the paths of each column of the first row.
  std::array<int, kW> sample(AdaptiveSampling& method, const Light& light) {
    std::array<int, kW> paths{};
    for (int round = 0, n; (n = method.nextRound(kSpp, pool)) > 0; ++round) {
      for (int y = 0; y < kH; ++y) {
        for (int x = 0; x < kW; ++x) {
          if (!method.wanted().at(x, y)) continue;
          cur.samples.I2.at(x, y) = light(x, round), paths[static_cast<std::size_t>(x)] += y == 0 ? n : 0;
        }
      }
      method.take(cur, pool);
    }
    return paths;
  }
  void start(AdaptiveSampling& method, const Light& light) {
    EXPECT_EQ(sample(method, light)[0], kSpp) << "the first frame has no test";
    method.start(cur, pool);
  }
  std::array<int, kW> step(AdaptiveSampling& method, const Light& light) {
    const std::array<int, kW> paths = sample(method, light);
    method.estimate({cur, prev}, pool, change, times);
    return paths;
  }
  // Log brightness, with noise of one seed for all frames.
  static Light noisy(const std::array<float, kW>& brightness) {
    return [=](int x, int round) {
      return std::exp(brightness[static_cast<std::size_t>(x)] + 0.1f * (test::randomAt(7, 0, round) - 0.5f)) -
             1e-3f;
    };
  }
  TilePool pool{1};
  Frame cur{kW, kH}, prev{kW, kH};
  IntensityChange change{kW, kH};
  StageTimes times;
};

// The paper's claim: sampling stops early but for pixels whose change is close to the threshold.
TEST_F(Fixture, SamplesUntilTheEventIsCertain) {
  AdaptiveSampling method({}, kW, kH);
  start(method, noisy({0, 0, 0, 0}));
  const std::array<int, kW> paths = step(method, noisy({0, 0.2f, 0.5f, -0.5f}));
  EXPECT_EQ(paths[0], 4) << "no event";
  EXPECT_EQ(paths[1], kSpp) << "at the threshold";
  EXPECT_EQ(paths[2], 4) << "ON";
  EXPECT_EQ(paths[3], 4) << "OFF";
}

TEST_F(Fixture, ShowsTheMeanOfAllRounds) {
  AdaptiveSampling method({}, kW, kH);
  start(method, [](int, int round) { return static_cast<float>(round); });
  EXPECT_FLOAT_EQ(cur.samples.I2.at(1, 1), 0.5f * (kSpp - 1));
  step(method, [](int, int) { return 40.f; });
  EXPECT_FLOAT_EQ(change.I_now.at(1, 1), 40);
  EXPECT_FLOAT_EQ(change.dI.at(1, 1), 40 - 0.5f * (kSpp - 1));
}

TEST_F(Fixture, HoldsThePixelUntilAnEvent) {
  AdaptiveSampling method({.hold = true}, kW, kH);
  const auto steady = [](float light) { return [=](int, int) { return light; }; };
  start(method, steady(1));
  for (const float light : {1.1f, 1.2f}) {
    step(method, steady(light));
    EXPECT_EQ(change.dI.at(0, 0), 0);
    EXPECT_EQ(change.I_now.at(0, 0), 1);
  }
  step(method, steady(1.3f));
  EXPECT_FLOAT_EQ(change.dI.at(0, 0), 0.3f);
  step(method, steady(1.5f));
  EXPECT_EQ(change.dI.at(0, 0), 0) << "the event has set a new level";
}

TEST_F(Fixture, TakesAnyNumberOfPaths) {
  AdaptiveSampling method({}, kW, kH);
  for (const int spp : {1, 3, 64, 100, 4096}) {
    int all = 0;
    for (int n; (n = method.nextRound(spp, pool)) > 0; all += n) method.take(cur, pool);
    EXPECT_LE(all, spp);
    EXPECT_GE(all, spp - spp % 64 * (spp > 64)) << spp;
  }
}

}  // namespace
}  // namespace saccade
