// The odds that events are artefacts agree with a reference of many paths.
#include <gtest/gtest.h>

#include "eval/bench/bench.h"
#include "eval/figures/odds_bins.h"

namespace saccade::eval {
namespace {

OddsBins oddsIn(const std::string& scene, int spp) {
  TilePool pool(2);
  const Bench bench({.scene = scene,
                     .width = 48,
                     .height = 36,
                     .frame_rate_hz = 250,
                     .first = 14,
                     .last = 16,
                     .reference_spp = 2048,
                     .cache = ::testing::TempDir() + "saccade-cache"},
                    pool);
  const BenchRun run = bench.run(parseMethod("event_svgf"), spp, 1);
  const OddsBins odds = binsOfOdds(sequenceOf(run), sequenceOf(bench.truth()), 1e-3, 0.05);
  const OddsBin all = odds.mean();
  std::printf("%s, %d spp: %.0f events, odds %.3f, false %.3f, error %.3f; reference %.3f\n", scene.c_str(),
              spp, all.events, all.odds, all.false_share, odds.error(), bench.referenceError());
  for (const OddsBin& bin : odds.bins)
    std::printf("  %6.0f events, odds %.3f, false %.3f\n", bin.events, bin.odds, bin.false_share);
  return odds;
}

// Events of odds above a half are false more than twice as often as those below a tenth.
void expectHonest(const OddsBins& odds) {
  const OddsBin all = odds.mean(), high = odds.mean(kOddsBins / 2);
  EXPECT_NEAR(all.odds, all.false_share, 0.08);
  EXPECT_LT(odds.error(), 0.12);
  EXPECT_GT(high.false_share, 2 * odds.bins.front().false_share);
}

TEST(OddsQuality, FlatWalls) {
  expectHonest(oddsIn("cornell-box", 2));
}
TEST(OddsQuality, CurvedMesh) {
  expectHonest(oddsIn("cornell-bunny", 2));
}
TEST(OddsQuality, ManyPaths) {
  expectHonest(oddsIn("textured-cornell-box", 8));
}

}  // namespace
}  // namespace saccade::eval
