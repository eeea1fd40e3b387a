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

// The ratio of errors found and claimed, of all pixels and of the typical one.
class Claims {
 public:
  void add(double found, double claimed) {
    found_ += found, claimed_ += claimed;
    if (claimed > 0) ratios_.push_back(found / claimed);
  }
  void expectHonest() {
    const auto middle = ratios_.begin() + ratios_.size() / 2;
    std::nth_element(ratios_.begin(), middle, ratios_.end());
    EXPECT_GT(found_ / claimed_, 0.4);
    EXPECT_LT(found_ / claimed_, 3);
    EXPECT_GT(*middle, 0.25);
    EXPECT_LT(*middle, 4);
  }

 private:
  std::vector<double> ratios_;
  double found_ = 0, claimed_ = 0;
};

// The variance of the change is that over repeats. That of the picture holds the detail that is left out as
// well: the squared error against the truth, whose own variance is subtracted.
TEST(IrradianceCache, ItsVariancesAreThoseOfRepeatsAndOfErrors) {
  constexpr int kRepeats = 8;
  TilePool pool(2);
  const Bench bench(setup(512), pool);
  const IntensityChange& truth = bench.truth().back().change;
  std::vector<IntensityChange> repeats;
  for (std::uint64_t seed = 1; seed <= kRepeats; ++seed) {
    BenchRun run = bench.run(parseMethod("irradiance_cache"), 2, seed);
    repeats.push_back(std::move(run.changes.back()));
  }
  Claims change, picture;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      double sum = 0, squares = 0, change_claim = 0, error = 0, picture_claim = 0;
      for (const IntensityChange& r : repeats) {
        const double dI = r.dI.at(x, y), off = r.I_prev.at(x, y) - truth.I_prev.at(x, y);
        sum += dI, squares += dI * dI, change_claim += r.var_dI.at(x, y) / kRepeats;
        error += off * off / kRepeats, picture_claim += r.var_I_prev.at(x, y) / kRepeats;
      }
      change.add((squares - sum * sum / kRepeats) / (kRepeats - 1), change_claim);
      picture.add(error - truth.var_I_prev.at(x, y), picture_claim);
    }
  }
  change.expectHonest();
  picture.expectHonest();
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
  EXPECT_LT(baked.false_events + baked.missed_events, 0.75 * (cold.false_events + cold.missed_events));
}

}  // namespace
}  // namespace saccade::eval
