#include "eval/bench/score.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "eval/planes.h"

namespace saccade::eval {
namespace {

using test::plane;

constexpr double kBias = 0.5, kC = 0.2;
constexpr float kLuminance = 0.5f;  // I_prev everywhere: kBias + kLuminance = 1

// A frame of 10 ms in which the brightness changes by dL >= log(1/2) [E (21)].
IntensityChange frameOf(const ImageF& dL, int frame) {
  IntensityChange change(dL.width(), 1);
  change.t0 = TimeNs((frame - 1) * 10'000'000), change.t1 = TimeNs(frame * 10'000'000);
  change.frame = static_cast<FrameIndex>(frame);
  for (int x = 0; x < dL.width(); ++x) change.dI.at(x, 0) = std::expm1(dL.at(x, 0));
  change.I_prev.fill(kLuminance);
  return change;
}

// The halves have the changes of brightness dL + apart and dL - apart. `regions` has one entry per pixel.
Truth truthOf(const ImageF& dL, const std::vector<std::uint32_t>& regions, int frame = 1, float apart = 0) {
  const int w = dL.width();
  ReferenceFrame prev(w, 1), cur(w, 1);
  for (int x = 0; x < w; ++x) {
    prev.a.at(x, 0) = prev.b.at(x, 0) = kLuminance;
    cur.a.at(x, 0) = kLuminance + std::expm1(dL.at(x, 0) + apart);
    cur.b.at(x, 0) = kLuminance + std::expm1(dL.at(x, 0) - apart);
  }
  RegionMap map(w, 1);
  std::copy(regions.begin(), regions.end(), map.row(0));
  Truth truth{{prev, cur}, std::move(map)};
  truth.change.copyFrom(frameOf(dL, frame));
  return truth;
}

// The frames 1, 2 and so on have these changes of brightness.
template <class... Planes>
BenchRun runOf(const Planes&... dL) {
  BenchRun run;
  int frame = 0;
  (run.changes.push_back(frameOf(dL, ++frame)), ...);
  return run;
}

template <class First, class... Rest>
std::vector<First> listOf(First first, Rest... rest) {
  std::vector<First> list;
  list.push_back(std::move(first));
  (list.push_back(std::move(rest)), ...);
  return list;
}

constexpr std::uint32_t kSmooth = region::kSmooth, kCurved = region::kCurved, kChanged = region::kChanged;
constexpr double kTolerance = 1e-6, kInfinity = std::numeric_limits<double>::infinity();

TEST(Score, OfTheTruthItselfIsZeroInEveryColumnAndAllOfItArrives) {
  const ImageF dL = plane({0.5f, -0.4f, 0.3f, 0.6f});
  const std::vector<std::uint32_t> regions{kSmooth, kCurved, kChanged, kSmooth};
  const auto truth = listOf(truthOf(dL, regions, 1), truthOf(dL, regions, 2));
  const Score score = scoreOf(truth, listOf(runOf(dL, dL), runOf(dL, dL)), kBias, kC);
  for (const ScoreColumn& column : kScoreColumns) {
    const bool is_share = column.value == &Score::dI_share || column.value == &Score::dL_share;
    EXPECT_NEAR(score.*column.value, is_share, kTolerance) << column.name;
  }
}

TEST(Score, TellsTheRegionsApart) {
  const auto truth = listOf(truthOf(plane({0, 0, 0, 0.1f}), {kSmooth, kSmooth, kCurved, kChanged}));
  const Score score = scoreOf(truth, listOf(runOf(plane({0.05f, 0.15f, -0.3f, 0}))), kBias, kC);
  // If one of the two changes is 0, the other has |dL| / C events [E (31)].
  EXPECT_NEAR(score.false_smooth, (0.05 + 0.15) / 2 / kC, kTolerance);
  EXPECT_NEAR(score.false_curved, 0.3 / kC, kTolerance);
  EXPECT_EQ(score.false_changed, 0);
  EXPECT_NEAR(score.false_events, (0.05 + 0.15 + 0.3) / 4 / kC, kTolerance);
  EXPECT_EQ(score.missed_smooth, 0);
  EXPECT_EQ(score.missed_curved, 0);
  EXPECT_NEAR(score.missed_changed, 0.1 / kC, kTolerance);
  EXPECT_NEAR(score.missed_events, 0.1 / 4 / kC, kTolerance);

  EXPECT_NEAR(score.rms_smooth, std::sqrt((0.0025 + 0.0225) / 2), kTolerance);
  EXPECT_NEAR(score.rms_curved, 0.3, kTolerance);
  EXPECT_NEAR(score.rms_changed, 0.1, kTolerance);
  EXPECT_NEAR(score.rms_dL, std::sqrt((0.0025 + 0.0225 + 0.09 + 0.01) / 4), kTolerance);

  const double floor = 0.01 * 0.1 / 4;
  EXPECT_NEAR(score.dL_l1, (0.05 + 0.15 + 0.3 + 0.1) / 0.1, 1e-5);
  EXPECT_NEAR(score.dL_mape / (((0.05 + 0.15 + 0.3) / floor + 0.1 / (0.1 + floor)) / 4), 1, 1e-5);
  const double dI = std::expm1(0.1), false_dI = std::expm1(0.05) + std::expm1(0.15) - std::expm1(-0.3);
  EXPECT_NEAR(score.dI_l1, (false_dI + dI) / dI, 1e-5);
  EXPECT_NEAR(score.dI_mape / ((false_dI / (0.01 * dI / 4) + 1 / (1 + 0.01 / 4)) / 4), 1, 1e-5);
}

// The errors are 0.1 and 0.3 in the first frame, and 0 in the second.
TEST(Score, IsTheMeanOverFramesAndRepeats) {
  const auto truth = listOf(truthOf(plane({-0.1f}), {kSmooth}, 1), truthOf(plane({0.2f}), {kSmooth}, 2));
  const auto repeats = listOf(runOf(plane({0}), plane({0.2f})), runOf(plane({0.2f}), plane({0.2f})));
  const Score score = scoreOf(truth, repeats, kBias, kC);
  EXPECT_NEAR(score.dL_l1, (0.1 / 0.1 + 0.3 / 0.1) / 4, 1e-5);
  EXPECT_NEAR(score.rms_dL, std::sqrt((0.01 + 0.09) / 4), kTolerance);
  const double variance = 0.02;  // of 0 and 0.2
  EXPECT_NEAR(score.sigma_dL, std::sqrt(variance) / 2, kTolerance);
  EXPECT_NEAR(score.noise_dL, std::sqrt(variance / 2), kTolerance);
  EXPECT_NEAR(score.bias_dL, std::sqrt((0.04 - variance / 2) / 2), kTolerance);
}

// The halves of the truth have errors of +0.1 and -0.1. The method is right, or has an error of 0.2.
TEST(Score, IsFreeOfTheNoiseOfTheTruth) {
  const auto truth = listOf(truthOf(plane({0.1f}), {kCurved}, 1, 0.1f));
  EXPECT_NEAR(scoreOf(truth, listOf(runOf(plane({0.1f}))), kBias, kC).rms_dL, -0.1, kTolerance);
  const auto off = listOf(runOf(plane({0.3f})), runOf(plane({0.3f})));
  const Score score = scoreOf(truth, off, kBias, kC);
  for (const double error : {score.rms_dL, score.rms_curved, score.bias_dL})
    EXPECT_NEAR(error, std::sqrt(0.04 - 0.01), kTolerance);
}

// The halves are as above, and each has its own denominator. Half of the change arrives.
TEST(Score, ComparesWithEachHalfByItself) {
  auto truth = listOf(truthOf(plane({0.2f, 0}), {kCurved, kCurved}, 1, 0.1f));
  const auto half = listOf(runOf(plane({0.1f, 0})));
  const Score score = scoreOf(truth, half, kBias, kC);
  // (0.1 - 0.3) (0.1 - 0.1) + (0 - 0.1) (0 + 0.1), over 0.3 0.1 - 0.1 0.1
  EXPECT_EQ(score.dL_error, 0);
  EXPECT_NEAR(score.dL_share, 0.1 * 0.2 / (0.3 * 0.1 - 0.01), 1e-5);
  const double a = std::expm1(0.3), b = std::expm1(0.1), off = std::expm1(0.1) * std::expm1(-0.1);
  EXPECT_NEAR(score.dI_share, b * (a + b) / 2 / (a * b + off), 1e-5);
  // The first pixel: 0.3 has an event at each phase, and 0.1 at half of them. The second: 0.1 and -0.1 have
  // theirs at other phases.
  EXPECT_NEAR(ownFalseEvents(truth, kBias, kC), (0.1 + 0.2) / kC / 2 / 4, kTolerance);

  // With half the denominator in half b, its first dL is log(1 + 2 dI). There is nothing to fall from.
  truth[0].prev_b.fill(0);
  const double in_a = 0.3, in_b = std::log1p(2 * b);
  EXPECT_NEAR(scoreOf(truth, half, kBias, kC).dL_share, 0.1 * (in_a + in_b) / 2 / (in_a * in_b), 1e-5);
}

// The change comes two frames of 10 ms late. The number of events is right, but all are in other voxels and
// beyond the cap of 5 ms.
TEST(Score, OfALateRunIsWrongInTimeAlone) {
  const ImageF none = plane({0, 0}), step = plane({0.5f, -0.5f});
  const auto truth = listOf(truthOf(step, {kSmooth, kSmooth}, 1), truthOf(none, {kSmooth, kSmooth}, 2),
                            truthOf(none, {kSmooth, kSmooth}, 3));
  const auto late = [&] { return runOf(none, none, step); };
  const Score score = scoreOf(truth, listOf(late()), kBias, kC);
  EXPECT_EQ(score.count_error, 0);
  EXPECT_EQ(score.voxel_error, 2);
  EXPECT_EQ(score.time_error_ms, 5);
  // The mean over this repeat and one that is right.
  const Score half = scoreOf(truth, listOf(late(), runOf(step, none, none)), kBias, kC);
  EXPECT_EQ(half.count_error, 0);
  EXPECT_EQ(half.voxel_error, 1);
  EXPECT_EQ(half.time_error_ms, 2.5);
  // A repeat without an event has no time.
  EXPECT_EQ(scoreOf(truth, listOf(late(), runOf(none, none, none)), kBias, kC).time_error_ms, 5);
}

// After a rise by 2 C all levels lie in [0, C), evenly. To rise by C gives each pixel an event, at even
// phases. A fall by 2 C gives each an event in the second half, since the OFF threshold lies C below 0. So
// half of the events are in another tenth.
TEST(Score, TellsPhasesAfterTheFirstFrame) {
  constexpr int kWidth = 5'000;
  const auto everywhere = [](float dL) {
    ImageF image(kWidth, 1);
    image.fill(dL);
    return image;
  };
  const ImageF rise = everywhere(0.4f), on = everywhere(0.2f), turn = everywhere(-0.4f);
  const std::vector<std::uint32_t> regions(kWidth, kSmooth);
  const auto truth = listOf(truthOf(rise, regions, 1), truthOf(on, regions, 2));
  EXPECT_NEAR(scoreOf(truth, listOf(runOf(rise, turn)), kBias, kC).phase_error, 0.5, 0.02);
  // In the mean of squares with a repeat that is right.
  const auto half = listOf(runOf(rise, turn), runOf(rise, on));
  EXPECT_NEAR(scoreOf(truth, half, kBias, kC).phase_error, std::sqrt(0.25 / 2), 0.02);
  // The start of the sensor spreads the events of a single frame, whatever the method.
  const auto single = listOf(truthOf(on, regions, 1));
  EXPECT_TRUE(std::isnan(scoreOf(single, listOf(runOf(turn)), kBias, kC).phase_error));
}

TEST(Score, HasNoNoiseOfASingleRepeat) {
  const auto truth = listOf(truthOf(plane({0.1f}), {kSmooth}));
  const Score score = scoreOf(truth, listOf(runOf(plane({0.2f}))), kBias, kC);
  for (const double unknown : {score.sigma_dL, score.noise_dL, score.bias_dL})
    EXPECT_TRUE(std::isnan(unknown));
  EXPECT_NEAR(score.rms_dL, 0.1, kTolerance);
}

TEST(Score, IsUnknownWhereThereIsNoPixelOrEvent) {
  const auto truth = listOf(truthOf(plane({0.1f}), {kChanged}, 1), truthOf(plane({0.1f}), {kSmooth}, 2));
  const auto repeats = listOf(runOf(plane({0}), plane({0})), runOf(plane({0.2f}), plane({0})));
  const Score score = scoreOf(truth, repeats, kBias, 10);
  for (const double unknown :
       {score.false_curved, score.missed_curved, score.rms_curved, score.time_error_ms})
    EXPECT_TRUE(std::isnan(unknown));
  // A frame without such pixels does not count.
  EXPECT_NEAR(score.rms_changed, 0.1, kTolerance);
  EXPECT_NEAR(score.rms_smooth, 0.1, kTolerance);
  EXPECT_EQ(score.sigma_dL, 0);
  EXPECT_GT(score.noise_dL, 0);
}

TEST(Score, IsInfiniteWhereTheTruthStandsStill) {
  const auto truth = listOf(truthOf(plane({0}), {kSmooth}));
  const Score score = scoreOf(truth, listOf(runOf(plane({0.3f}))), kBias, kC);
  for (const double error :
       {score.dI_l1, score.dI_mape, score.dL_l1, score.dL_mape, score.count_error, score.voxel_error})
    EXPECT_EQ(error, kInfinity);
  for (const double unknown : {score.dI_error, score.dI_share, score.dL_error, score.dL_share})
    EXPECT_TRUE(std::isnan(unknown));
  EXPECT_NEAR(score.false_events, 0.3 / kC, kTolerance);
}

TEST(ScoreColumns, AreFoundAndNamed) {
  EXPECT_STREQ(columnOf(&Score::noise_dL).name, "noise_dL");
  for (const ScoreColumn& column : kScoreColumns)
    EXPECT_NE(scoreNames().find(column.name), std::string::npos) << column.name;
}

}  // namespace
}  // namespace saccade::eval
