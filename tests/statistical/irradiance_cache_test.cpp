// The method that keeps light on surfaces, against the methods of the paper and against repeats of itself.
#include <gtest/gtest.h>

#include <algorithm>

#include "eval/bench/bench.h"
#include "eval/bench/score.h"

namespace saccade::eval {
namespace {

constexpr int kSize = 48;

BenchSetup setup(int reference_spp, bool jitter = false) {
  return {.width = kSize,
          .height = kSize,
          .px_per_frame = 0.5,
          .jitter = jitter,
          .first = 15,
          .last = 16,
          .reference_spp = reference_spp,
          .cache = ::testing::TempDir() + "saccade-irradiance-cache"};
}

class IrradianceCacheOf : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(, IrradianceCacheOf, testing::Bool(),
                         [](const auto& info) { return info.param ? "WholePixels" : "PixelCentres"; });

// In the same time as the better of both.
TEST_P(IrradianceCacheOf, ErrsFarLessThanMethodsThatKeepLightInThePicture) {
  TilePool pool(2);
  const Bench bench(setup(512, GetParam()), pool);
  const auto score = [&](const char* method, int spp) {
    const BenchRun run = bench.run(parseMethod(method), spp, 1);
    return scoreOf(bench.truth(), {&run, 1}, 1e-3, 0.2);
  };
  const Score ours = score("irradiance_cache", 2), event = score("event_svgf", 2), svgf = score("svgf", 2);
  EXPECT_LT(ours.dI_l1, 0.6 * std::min(event.dI_l1, svgf.dI_l1));
  const auto wrong = [](const Score& score) { return score.false_events + score.missed_events; };
  EXPECT_LT(wrong(ours), 0.7 * std::min(wrong(event), wrong(svgf)));
}

// Of all pixels, and of the typical one.
TEST(IrradianceCache, ItsVariancesAreThoseOfRepeats) {
  constexpr int kRepeats = 8;
  TilePool pool(2);
  const Bench bench(setup(0), pool);
  std::vector<IntensityChange> repeats;
  for (std::uint64_t seed = 1; seed <= kRepeats; ++seed) {
    BenchRun run = bench.run(parseMethod("irradiance_cache"), 2, seed);
    repeats.push_back(std::move(run.changes.back()));
  }
  const auto check = [&](ImageF IntensityChange::*value, ImageF IntensityChange::*variance) {
    std::vector<double> ratios;
    double found = 0, claimed = 0;
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        double sum = 0, squares = 0, said = 0;
        for (const IntensityChange& r : repeats) {
          const double v = (r.*value).at(x, y);
          sum += v, squares += v * v, said += (r.*variance).at(x, y) / kRepeats;
        }
        const double spread = (squares - sum * sum / kRepeats) / (kRepeats - 1);
        found += spread, claimed += said;
        if (said > 0) ratios.push_back(spread / said);
      }
    }
    std::nth_element(ratios.begin(), ratios.begin() + ratios.size() / 2, ratios.end());
    EXPECT_GT(found / claimed, 0.4);
    EXPECT_LT(found / claimed, 2.5);
    EXPECT_GT(ratios[ratios.size() / 2], 0.25);
    EXPECT_LT(ratios[ratios.size() / 2], 4);
  };
  check(&IntensityChange::I_prev, &IntensityChange::var_I_prev);
  check(&IntensityChange::dI, &IntensityChange::var_dI);
}

// In the first frames, with no path of its own. The error that is left is one of smoothing.
TEST(IrradianceCache, StartsConvergedWithABake) {
  TilePool pool(2);
  BenchSetup start = setup(512);
  start.first = 1, start.last = 2;
  const Bench without(start, pool);
  start.bake_error = 0.02;
  const Bench with(start, pool);
  const auto score = [](const Bench& bench) {
    const BenchRun run = bench.run(parseMethod("irradiance_cache"), 1, 1);
    return scoreOf(bench.truth(), {&run, 1}, 1e-3, 0.2);
  };
  const Score cold = score(without), baked = score(with);
  EXPECT_LT(baked.dI_l1, 0.7 * cold.dI_l1);
  EXPECT_LT(baked.false_events + baked.missed_events, 0.7 * (cold.false_events + cold.missed_events));
}

}  // namespace
}  // namespace saccade::eval
