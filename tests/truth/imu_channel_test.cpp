#include <gtest/gtest.h>

#include "app/interval_of.h"
#include "truth/truth_source.h"

namespace saccade {
namespace {

// 5 rows in each interval.
const TruthConfig kNoisy{
    .name = "imu",
    .frames = FrameSelection(),
    .imu = {
        .rate_hz = 1000, .accelerometer_noise = 1, .gyroscope_noise = 1, .accelerometer_walk = 1, .seed = 3}};

TruthSamples rowsOf(FrameIndex first, FrameIndex last) {
  const auto source = findTruth("imu")->make(kNoisy);
  TruthSamples rows;
  for (FrameIndex frame = first; frame <= last; ++frame) {
    const StillView view(intervalOf(frame, 1, 0));
    for (TruthSample& row : source->sample(view.interval())) rows.push_back(std::move(row));
  }
  return rows;
}

TEST(ImuChannel, RowsComeAtTheRateFromTheEndOfTheFirstPeriodOn) {
  const TruthSamples rows = rowsOf(1, 3);
  ASSERT_EQ(rows.size(), 15u);
  for (std::size_t i = 0; i < rows.size(); ++i)
    EXPECT_EQ(rows[i].t_ns, 1'000'000 * static_cast<std::int64_t>(i + 1));
}

// A stream may join a feed that runs.
TEST(ImuChannel, RowsDoNotDependOnTheFirstInterval) {
  const TruthSamples all = rowsOf(1, 6), late = rowsOf(4, 6);
  EXPECT_EQ(late, TruthSamples(all.begin() + 15, all.end()));
  EXPECT_NE(all[0].elements, all[1].elements);
}

}  // namespace
}  // namespace saccade
