#include "eval/metrics/event_streams.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace saccade::eval {
namespace {

constexpr std::int64_t kMs = 1'000'000;
const double kInfinity = std::numeric_limits<double>::infinity();

// In the reference, pixel (3, 4) has three ON events and one OFF event, and pixel (4, 3) has one ON event.
const Events kRef = {
    {1 * kMs, 3, 4, 1}, {2 * kMs, 3, 4, 1}, {3 * kMs, 4, 3, 1}, {7 * kMs, 3, 4, 1}, {8 * kMs, 3, 4, 0}};

TEST(CountError, CountsPixelsAndPolaritiesApart) {
  EXPECT_EQ(countError(kRef, kRef), 0);
  EXPECT_EQ(countError({}, kRef), 1);
  // ON of (3, 4): 1 for 3. OFF of (3, 4): 2 for 1. (4, 3): none for 1. (9, 9): 1 for none. So 2 + 1 + 1 + 1
  // over 5.
  const Events x = {{0, 3, 4, 1}, {1, 3, 4, 0}, {2, 3, 4, 0}, {3, 9, 9, 1}};
  EXPECT_DOUBLE_EQ(countError(x, kRef), 5.0 / 5);
  EXPECT_DOUBLE_EQ(countError(kRef, x), 5.0 / 4);
}

TEST(CountError, OfEmptyStreams) {
  EXPECT_EQ(countError({}, {}), 0);
  EXPECT_EQ(countError(kRef, {}), kInfinity);
  EXPECT_EQ(voxelError({}, {}), 0);
  EXPECT_EQ(voxelError(kRef, {}), kInfinity);
}

// The voxels of the reference have size 3. (3, 4) has +2 in [0, 5) ms and +1 - 1 in [5, 10). (4, 3) has +1.
TEST(VoxelError, SumsPolarityInPixelAndBin) {
  EXPECT_EQ(voxelError(kRef, kRef), 0);
  EXPECT_DOUBLE_EQ(voxelError({}, kRef), 1);
  Events moved = kRef;
  moved[1].t_ns = 5 * kMs - 1;  // still in its bin
  EXPECT_EQ(voxelError(moved, kRef), 0);
  moved[1].t_ns = 5 * kMs;  // one too few in the first, one too many in the next
  EXPECT_DOUBLE_EQ(voxelError(moved, kRef), 2.0 / 3);
  EXPECT_EQ(voxelError(moved, kRef, 10 * kMs), 0);
  moved[2].x = 5;  // and in another pixel
  EXPECT_DOUBLE_EQ(voxelError(moved, kRef), 4.0 / 3);
  moved[2].p = 0;
  EXPECT_DOUBLE_EQ(voxelError(moved, kRef), 4.0 / 3);
}

TEST(NearestTimeError, LooksBothWaysInTheSamePixelAndPolarity) {
  const Events x = {
      {1 * kMs + 300'000, 3, 4, 1},  // 0.3 ms after the first
      {4 * kMs, 3, 4, 1},            // 2 ms after the second, 3 before the next
      {6 * kMs, 3, 4, 1},            // 1 ms before the third
      {8 * kMs, 3, 4, 0},            // exact
  };
  const TimeError error = nearestTimeError(x, kRef, 5 * kMs);
  EXPECT_DOUBLE_EQ(error.mean_ns, (0.3 + 2 + 1 + 0) * kMs / 4);
  EXPECT_EQ(error.capped, 0u);
}

TEST(NearestTimeError, CapsWhatHasNoMatchAndCountsIt) {
  const Events x = {
      {3 * kMs, 4, 3, 1},  // exact
      {3 * kMs, 4, 3, 0},  // nothing of its polarity
      {3 * kMs, 4, 4, 1},  // nothing in its pixel
      {5 * kMs, 4, 3, 1},  // at the cap: a match
      {6 * kMs, 4, 3, 1},  // beyond it
  };
  const TimeError error = nearestTimeError(x, kRef, 2 * kMs);
  EXPECT_DOUBLE_EQ(error.mean_ns, (0 + 2 + 2 + 2 + 2) * kMs / 5.0);
  EXPECT_EQ(error.capped, 3u);
}

TEST(NearestTimeError, OfNoEventIsUnknown) {
  EXPECT_TRUE(std::isnan(nearestTimeError({}, kRef, kMs).mean_ns));
  EXPECT_EQ(nearestTimeError(kRef, {}, kMs).capped, kRef.size());
}

}  // namespace
}  // namespace saccade::eval
