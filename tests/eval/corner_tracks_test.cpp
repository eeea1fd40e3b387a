#include "eval/tasks/corner_tracks.h"

#include <gtest/gtest.h>

#include <limits>

#include "eval/task_truths.h"
#include "eval/tasks/active_events.h"
#include "eval/tasks/efast.h"
#include "eval/tasks/task.h"

namespace saccade::eval {
namespace {

constexpr int kSize = 40;
constexpr TimeNs kMs{1'000'000};

// The times of an edge that has just come to the middle.
template <class Time>
Image<double> edge(Time time) {
  Image<double> times(kSize, kSize);
  times.fill(-std::numeric_limits<double>::infinity());
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x)
      if (const double t = time(x - 20, y - 20); t <= 0) times.at(x, y) = t;
  return times;
}

TEST(EFast, TellsCornersFromEdges) {
  const auto square = edge([](int x, int y) { return x < 0 || y < 0 ? 1.0 : -0.01 * std::min(x, y); });
  EXPECT_TRUE(isCorner(square, 20, 20));
  EXPECT_FALSE(isCorner(square, 20, 28));  // on its side
  EXPECT_FALSE(isCorner(edge([](int x, int) { return 0.01 * x; }), 20, 20));
  EXPECT_FALSE(isCorner(edge([](int x, int y) { return 0.01 * (x + 0.3 * y); }), 20, 20));
}

TEST(EFast, LeavesOutTheBorder) {
  Image<double> times(kSize, kSize);
  EXPECT_FALSE(isCorner(times, 3, 20));
  EXPECT_FALSE(isCorner(times, 20, kSize - 4));
}

TEST(ActiveEvents, KeepTheFirstOfAnEdge) {
  ActiveEvents active(4, 4);
  EXPECT_TRUE(active.add({0, 1, 2, 1}));
  EXPECT_TRUE(active.add({10'000'000, 1, 2, 0}));   // of the other polarity
  EXPECT_FALSE(active.add({40'000'000, 1, 2, 1}));  // soon after
  EXPECT_FALSE(active.add({80'000'000, 1, 2, 1}));  // soon after that
  EXPECT_EQ(active.times(1).at(1, 2), 0);
  EXPECT_TRUE(active.add({140'000'000, 1, 2, 1}));
  EXPECT_DOUBLE_EQ(active.times(1).at(1, 2), 0.14);
}

TEST(CornerTracks, JoinWhatIsNearInSpaceAndTime) {
  CornerTracks tracks;
  tracks.add({10, 10}, 0 * kMs);
  tracks.add({20, 10}, 1 * kMs);
  EXPECT_EQ(tracks.add({12, 10}, 20 * kMs).begin, 0 * kMs);
  EXPECT_EQ(tracks.add({14, 10}, 60 * kMs).begin, 0 * kMs);
  EXPECT_EQ(tracks.add({20, 10}, 60 * kMs).begin, 60 * kMs);  // the former one there has ended
  EXPECT_EQ(tracks.add({14, 14}, 61 * kMs).begin, 61 * kMs);
}

TEST(TaskTruth, CarriesPointsAlongTheFlow) {
  const TaskTruth truth = test::steadyTruth(kSize, kSize, 10, {100, -50});
  const Vec2 there = truth.carried({10, 20}, 1 * kMs, 31 * kMs);
  EXPECT_NEAR(there.x, 13, 1e-4);
  EXPECT_NEAR(there.y, 18.5, 1e-4);
}

TEST(TaskTruth, TakesTheSurfaceInFront) {
  TaskTruth truth = test::steadyTruth(kSize, kSize, 2, {100, 0});
  truth.frames[1].z.at(10, 10) = 0.5f, truth.frames[1].flow_x.at(10, 10) = 7;
  EXPECT_EQ(truth.flowAt({11, 9}, 5 * kMs).x, 7);
  EXPECT_EQ(truth.flowAt({12, 9}, 5 * kMs).x, 100);
  EXPECT_EQ(truth.flowAt({11, 9}, 3 * kMs).x, 100);  // the frame before
}

// A square comes from the lower right. Its corner goes up and left by a pixel of each axis in 10 ms.
TEST(CornerTracks, AreScoredAgainstTheFlow) {
  Events events;
  for (int step = 0; step < 20; ++step) {
    const auto corner = static_cast<std::uint16_t>(30 - step);
    const std::int64_t t = step * 10 * kMs.count();
    for (std::uint16_t i = kSize - 1; i > corner; --i) {
      events.push_back({t, corner, i, 1}), events.push_back({t, i, corner, 1});
    }
    events.push_back({t, corner, corner, 1});
  }
  const TaskScore right =
      scoreCornerTracks({events, {}, 0.2, 1e-3, test::steadyTruth(kSize, kSize, 60, {-100, -100})});
  EXPECT_EQ(right.error, 0);
  EXPECT_GT(right.answers, 10u);
  EXPECT_GT(scoreCornerTracks({events, {}, 0.2, 1e-3, test::steadyTruth(kSize, kSize, 60, {100, 100})}).error,
            0.9);
}

}  // namespace
}  // namespace saccade::eval
