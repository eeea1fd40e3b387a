// Every metric moves the right way on rendered frames with known faults: added noise, a shifted picture, no
// history and so on. The test fails at a column of scores that no case moves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/hash_rng.h"
#include "eval/bench/score.h"
#include "eval/metrics/for_each_pixel.h"
#include "scene/scratch.h"

namespace saccade::eval {
namespace {

constexpr double kBias = 1e-2, kC = 0.2;
constexpr float kNoise = 0.2f;

using Columns = std::vector<double Score::*>;

// A frame of one repeat. The case adds a fault to it.
struct Spoilt {
  IntensityChange& change;
  const RegionMap& regions;
  std::uint64_t seed;
};

// Adds +- kNoise times the brightness at the end of the frame. That changes dL by log(1 +- kNoise) [E (21)].
void addNoise(const Spoilt& s) {
  const std::uint64_t frame = hashKey(s.seed, s.change.frame);
  forEachPixel(s.change.dI, [&](int x, int y) {
    const std::uint64_t pixel = static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint64_t>(x);
    float& dI = s.change.dI.at(x, y);
    const float brightness = static_cast<float>(kBias) + s.change.I_prev.at(x, y) + dI;
    dI += (hashKey(frame, pixel) & 1 ? kNoise : -kNoise) * brightness;
  });
}

// Shifts by one pixel to the left. The first column goes to the right.
void shift(const Spoilt& s) {
  for (ImageF* plane : {&s.change.dI, &s.change.I_prev, &s.change.I_now}) {
    for (int y = 0; y < plane->height(); ++y)
      std::rotate(plane->row(y), plane->row(y) + 1, plane->row(y) + plane->width());
  }
}

void delayByAFrame(const Spoilt& s) {
  const TimeNs frame = s.change.t1 - s.change.t0;
  s.change.t0 += frame, s.change.t1 += frame;
}

template <std::uint32_t kWhere>
void scaleChange(const Spoilt& s, float scale) {
  forEachPixel(s.change.dI, [&](int x, int y) {
    if (s.regions.at(x, y) & kWhere) s.change.dI.at(x, y) *= scale;
  });
}
void halve(const Spoilt& s) {
  scaleChange<region::kAnywhere>(s, 0.5f);
}
void twice(const Spoilt& s) {
  scaleChange<region::kAnywhere>(s, 2.f);
}
void turnSign(const Spoilt& s) {
  scaleChange<region::kAnywhere>(s, -1);
}
template <std::uint32_t kWhere>
void standStill(const Spoilt& s) {
  scaleChange<kWhere>(s, 0);
}

struct Case {
  const char* name;
  const char* method;
  void (*spoil)(const Spoilt&);  // or nullptr
  Columns up, down;              // by a tenth or more of what the unspoilt event_svgf has
  Columns same;
  double tolerance;  // of `same`, relative
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

const std::vector<Case>& cases() {
  using S = Score;
  constexpr const char* kMethod = "event_svgf";
  static const std::vector<Case> table{
      {"NoiseAdded",
       kMethod,
       addNoise,
       {&S::dI_l1,       &S::dI_error,     &S::dI_mape,      &S::dL_l1,         &S::dL_error,
        &S::dL_mape,     &S::false_events, &S::false_smooth, &S::false_curved,  &S::false_changed,
        &S::sigma_dL,    &S::noise_dL,     &S::rms_dL,       &S::rms_smooth,    &S::rms_curved,
        &S::rms_changed, &S::count_error,  &S::voxel_error,  &S::time_error_ms, &S::phase_error},
       {},
       {&S::bias_dL},
       0.1},
      {"PictureShifted",
       kMethod,
       shift,
       {&S::dI_l1, &S::dI_mape, &S::dL_l1, &S::dL_mape, &S::false_events, &S::missed_events, &S::bias_dL,
        &S::rms_dL, &S::rms_smooth, &S::rms_curved, &S::rms_changed, &S::count_error, &S::voxel_error,
        &S::time_error_ms},
       {},
       {&S::noise_dL},
       1e-6},
      {"HistoryHeldOff",
       "event_svgf:alpha=1",
       nullptr,
       {&S::sigma_dL, &S::noise_dL, &S::false_events, &S::false_smooth, &S::false_curved},
       {},
       {},
       0},
      {"OneFrameLate",
       kMethod,
       delayByAFrame,
       {&S::voxel_error, &S::time_error_ms},
       {},
       {&S::dI_l1, &S::dL_l1, &S::false_events, &S::missed_events, &S::rms_dL, &S::bias_dL, &S::noise_dL,
        &S::sigma_dL, &S::count_error},
       0},
      {"ChangeHalved",
       kMethod,
       halve,
       {&S::dI_l1, &S::dL_l1, &S::missed_events, &S::bias_dL, &S::rms_dL, &S::count_error},
       {&S::false_events, &S::false_smooth, &S::false_curved, &S::false_changed, &S::sigma_dL, &S::noise_dL},
       {},
       0},
      {"ChangeDoubled", kMethod, twice, {&S::dI_share, &S::dL_share}, {}, {}, 0},
      {"SignTurned",
       kMethod,
       turnSign,
       {&S::dI_l1, &S::dL_l1, &S::false_events, &S::missed_events, &S::bias_dL, &S::rms_dL, &S::count_error,
        &S::voxel_error, &S::time_error_ms},
       {},
       {},
       0},
      {"SmoothStandsStill",
       kMethod,
       standStill<region::kSmooth>,
       {&S::missed_smooth, &S::missed_events},
       {&S::false_smooth, &S::false_events},
       {&S::missed_curved, &S::missed_changed, &S::false_curved, &S::false_changed, &S::rms_curved,
        &S::rms_changed},
       0},
      {"CurvedStandsStill",
       kMethod,
       standStill<region::kCurved>,
       {&S::missed_curved},
       {&S::false_curved, &S::false_events},
       {&S::missed_smooth, &S::missed_changed, &S::false_smooth, &S::false_changed, &S::rms_smooth,
        &S::rms_changed},
       0},
      {"ChangedStandsStill",
       kMethod,
       standStill<region::kChanged>,
       {&S::missed_changed},
       {&S::false_changed},
       {&S::missed_smooth, &S::missed_curved, &S::false_smooth, &S::false_curved, &S::rms_smooth,
        &S::rms_curved},
       0},
  };
  return table;
}

class MetricsMove : public ::testing::TestWithParam<Case> {
 protected:
  Score scoreOfRuns(const char* method, void (*spoil)(const Spoilt&)) const {
    std::vector<BenchRun> repeats;
    for (const std::uint64_t seed : {1, 2}) {
      repeats.push_back(bench_.run(parseMethod(method), 2, seed));
      for (std::size_t f = 0; spoil && f < bench_.truth().size(); ++f)
        spoil({repeats.back().changes[f], bench_.truth()[f].regions, seed});
    }
    return scoreOf(bench_.truth(), repeats, kBias, kC);
  }

  Scratch files_;
  TilePool pool_{2};
  const Bench bench_{{.scene = "cornell-box",
                      .width = 40,
                      .height = 40,
                      .px_per_frame = 0.5,
                      .bounces = 1,
                      .first = 5,
                      .last = 6,
                      .reference_spp = 128,
                      .cache = files_.path("cache")},
                     pool_};
  const Score base_ = scoreOfRuns("event_svgf", nullptr);
};

TEST_P(MetricsMove, TheRightWay) {
  const Case& c = GetParam();
  const Score spoilt = scoreOfRuns(c.method, c.spoil);
  for (const auto column : c.up)
    EXPECT_GT(spoilt.*column, 1.1 * base_.*column) << columnOf(column).name << " ought to go up";
  for (const auto column : c.down)
    EXPECT_LT(spoilt.*column, 0.9 * base_.*column) << columnOf(column).name << " ought to go down";
  for (const auto column : c.same)
    EXPECT_NEAR(spoilt.*column, base_.*column, c.tolerance * base_.*column) << columnOf(column).name;
}

INSTANTIATE_TEST_SUITE_P(, MetricsMove, ::testing::ValuesIn(cases()),
                         [](const auto& c) { return std::string(c.param.name); });

// log(1 +- s) has a standard deviation of atanh(s), for any dL.
TEST_F(MetricsMove, NoiseByAsMuchAsWasAdded) {
  const double added = std::atanh(kNoise);
  const double noise = scoreOfRuns("event_svgf", addNoise).noise_dL;
  EXPECT_NEAR((noise * noise - base_.noise_dL * base_.noise_dL) / (added * added), 1, 0.05);
}

TEST(MetricsMoveCases, MoveEveryColumn) {
  for (const ScoreColumn& column : kScoreColumns) {
    EXPECT_TRUE(std::any_of(
        cases().begin(), cases().end(),
        [&](const Case& c) { return std::find(c.up.begin(), c.up.end(), column.value) != c.up.end(); }))
        << "no case makes " << column.name << " go up";
  }
}

}  // namespace
}  // namespace saccade::eval
