// Frames that are divided into intervals of equal motion.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

#include "base/counting_new.h"
#include "feed/interval_clock.h"
#include "feed/rig.h"
#include "feed/room.h"
#include "scene/motion/bodies.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;

constexpr int kSize = 64;
constexpr double kRate = 20;  // frames per second

std::array<double, IntervalClock::kSteps> evenly(double px) {
  std::array<double, IntervalClock::kSteps> steps;
  steps.fill(px / IntervalClock::kSteps);
  return steps;
}

TEST(IntervalClock, WithoutBoundsHasTheTimesOfFrames) {
  IntervalClock clock(700, {});
  for (FrameIndex frame = 1; frame <= 100; ++frame) {
    EXPECT_EQ(clock.advance(evenly(100)), frameTime(frame, 700));
    EXPECT_EQ(clock.frame(), frame);
    EXPECT_TRUE(clock.atFrame());
  }
}

TEST(IntervalClock, DividesAFrameIntoEqualMotion) {
  IntervalClock clock(kRate, {.px = 1});
  // 3.5 px are four intervals of 12.5 ms.
  for (int i = 1; i <= 4; ++i) {
    EXPECT_EQ(clock.advance(evenly(3.5 * (5 - i) / 4)), i * 12500us);
    EXPECT_EQ(clock.frame(), 1u);
    EXPECT_EQ(clock.atFrame(), i == 4);
  }
  EXPECT_EQ(clock.advance(evenly(1.001)), 100ms);
  EXPECT_EQ(clock.frame(), 2u);
}

// All motion is in the last two of 16 steps.
TEST(IntervalClock, IntervalsAreShortWhereMotionIsFast) {
  IntervalClock clock(kRate, {.px = 1});
  std::array<double, IntervalClock::kSteps> steps{};
  steps[14] = steps[15] = 1;
  EXPECT_EQ(clock.advance(steps), TimeNs(50ms) * 15 / 16);
  EXPECT_EQ(clock.advance(evenly(1)), 50ms);
}

TEST(IntervalClock, KeepsTheMostIntervalsPerSecond) {
  IntervalClock clock(kRate, {.px = 1, .max_rate_hz = 100});
  for (int i = 1; i <= 5; ++i) {
    EXPECT_EQ(clock.advance(evenly(1000)), i * 10ms);
  }
  IntervalClock slow(kRate, {.px = 1, .max_rate_hz = kRate});
  EXPECT_EQ(slow.advance(evenly(1000)), 50ms);
}

FeedConfig config(double px, int width = kSize) {
  FeedConfig c;
  c.camera = pinhole(90, width, kSize), c.frame_rate_hz = kRate, c.method = "event_svgf", c.seed = 3;
  c.intervals.px = px;
  std::string name;
  EXPECT_EQ(resolveParams(*findMethod(c.method), {}, c.params, name), "");
  return c;
}

// A wall at depth 4: by 1 to the side, the picture moves by a quarter of the focal length.
std::shared_ptr<const RenderScene> wall() {
  Scene s;
  s.materials = {test::grey(0.5f)};
  s.meshes = {test::quad({-90, -90, 4}, {180, 0, 0}, {0, 180, 0}, 0, {1, 1, 1})};
  return std::make_shared<RenderScene>(std::move(s));
}

// To the right at `speed`, from `begin` on.
Trajectory truck(double speed, TimeNs begin = TimeNs{0}) {
  std::vector<TimedPose> keys;
  if (begin > TimeNs{0}) keys.push_back({TimeNs{0}, {}});
  keys.push_back({begin, {}});
  keys.push_back({begin + 10s, {{10 * speed, 0, 0}, {}}});
  return Trajectory(std::move(keys));
}

// The ends of all intervals until `end`.
std::vector<TimeNs> endsOf(Rig& rig, TilePool& pool, TimeNs end) {
  std::vector<TimeNs> ends;
  while (ends.empty() || ends.back() < end) {
    const TimeNs t0 = ends.empty() ? TimeNs{0} : ends.back();
    const FeedInterval& interval = rig.step({pool}).front();
    EXPECT_EQ(interval.change.t0, t0);
    EXPECT_EQ(interval.change.frame, ends.size() + 1);
    EXPECT_EQ(interval.ends_frame, interval.change.t1 == frameTime(interval.frame, kRate));
    ends.push_back(interval.change.t1);
  }
  return ends;
}

TEST(RigIntervals, AreOnePixelOfMotion) {
  TilePool pool(1);
  // 130 px per second: 6.5 px in a frame of 50 ms.
  const double speed = 130.0 / (kSize / 2.0) * 4;
  Rig rig(std::make_unique<Feed>(wall(), truck(speed), config(1), pool));
  const std::vector<TimeNs> ends = endsOf(rig, pool, 100ms);
  ASSERT_EQ(ends.size(), 14u);
  for (std::size_t i = 0; i < ends.size(); ++i)
    EXPECT_NEAR(seconds(ends[i]), (static_cast<double>(i) + 1) * 0.05 / 7, 2e-5) << i;
}

TEST(RigIntervals, AreFramesWhereTheCameraRests) {
  TilePool pool(1);
  Rig rig(std::make_unique<Feed>(test::room(), truck(0.4, 200ms), config(0.5), pool));
  for (int i = 1; i <= 4; ++i) {
    const IntensityChange& change = rig.step({pool}).front().change;
    EXPECT_EQ(change.t1, i * 50ms);
    if (i > 1) {
      EXPECT_EQ(rig.lastTimes().total().count(), 0) << "nothing is rendered";
    }
    for (int x = 0; x < kSize; ++x) EXPECT_EQ(change.dI.at(x, 20), 0);
  }
  EXPECT_LT(rig.step({pool}).front().change.t1, 250ms);
  EXPECT_GT(rig.lastTimes().total().count(), 0);
}

// The motion after a rest is as after a short one.
TEST(RigIntervals, ARestChangesNothingOfTheMotionAfterIt) {
  TilePool pool(1);
  const auto changeAfter = [&](TimeNs rest) {
    Rig rig(std::make_unique<Feed>(test::room(), truck(0.4, rest), config(0.5), pool));
    while (rig.step({pool}).front().change.t1 < rest) {
    }
    const IntensityChange& change = rig.step({pool}).front().change;
    EXPECT_LT(change.t1, rest + 50ms);
    ImageF copy(kSize, kSize);
    copy.copyFrom(change.dI);
    return copy;
  };
  const ImageF a = changeAfter(50ms), b = changeAfter(500ms);
  double largest = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      EXPECT_EQ(a.at(x, y), b.at(x, y));
      largest = std::max<double>(largest, std::abs(a.at(x, y)));
    }
  EXPECT_GT(largest, 0);
}

// The second view shows the wall four times larger.
// not.
TEST(RigIntervals, AreThoseOfTheFastestView) {
  TilePool pool(1);
  std::vector<std::unique_ptr<Feed>> feeds;
  const double speed = 62.0 / (kSize / 2.0) * 4;
  for (const int width : {kSize, 4 * kSize})
    feeds.push_back(std::make_unique<Feed>(wall(), truck(speed), config(1, width), pool));
  Rig rig(std::move(feeds));
  int intervals = 1;
  while (!rig.step({pool}).back().ends_frame) ++intervals;
  EXPECT_EQ(intervals, 13);  // 3.1 px of the first view, and 12.4 of the second
}

// A card fills the view, and slides by 62 px per second for 75 ms; then it stands.
TEST(RigIntervals, FollowBodies) {
  Scene s;
  s.materials = {test::grey(0.5f)};
  s.meshes = {test::quad({-90, -90, 4}, {180, 0, 0}, {0, 180, 0}, 0, {1, 1, 1}),
              test::quad({-8, -8, 2}, {16, 0, 0}, {0, 16, 0}, 0, {1, 1, 1})};
  s.meshes[1].name = "card";
  const std::string names[]{"card"};
  setBodies(s, names);
  const Vec3d start = toDouble(s.bodies[0].centre());
  const double to = 62 * 0.075 / (kSize / 2.0) * 2;
  FeedConfig moving = config(1);
  moving.body_paths = {Trajectory({{TimeNs{0}, {start, {}}}, {TimeNs{75ms}, {start + Vec3d{to, 0, 0}, {}}}})};
  TilePool pool(1);
  Rig rig(std::make_unique<Feed>(std::make_shared<RenderScene>(std::move(s)), truck(0), moving, pool));
  // 3.1 px in the first frame; 1.55 px in the first half of the second one, at equal motion.
  const std::vector<TimeNs> ends = endsOf(rig, pool, 150ms);
  ASSERT_EQ(ends.size(), 7u);
  EXPECT_NEAR(seconds(ends[0]), 0.0125, 2e-5);
  EXPECT_NEAR(seconds(ends[4]), 0.0625, 2e-5);
  EXPECT_EQ(ends[5], 100ms);
  EXPECT_EQ(rig.lastTimes().total().count(), 0) << "the third frame rests";
}

// A wall at depth 4, in the light of a lamp at -8, with a card between them behind the camera.
Scene shadowOfACard(const std::string& body) {
  Scene s;
  s.materials = {test::grey(0.5f)};
  s.meshes = {test::quad({-90, -90, 4}, {0, 180, 0}, {180, 0, 0}, 0),
              test::quad({-1, -1, -2}, {2, 0, 0}, {0, 2, 0}, 0)};
  s.meshes[1].name = "card";
  s.spheres = {{.name = "lamp", .center = {0, 0, -8}, .radius = 0.01f, .radiance = {9, 9, 9}}};
  const std::string names[]{body};
  setBodies(s, names);
  return s;
}

// The shadow of the card moves twice as fast as the card, and as fast as the lamp, by 62 px per second.
TEST(RigIntervals, FollowShadows) {
  for (const auto& [body, factor] : {std::pair{"card", 2.0}, std::pair{"lamp", 1.0}}) {
    Scene s = shadowOfACard(body);
    const Vec3d start = toDouble(s.bodies[0].centre());
    const double to = 62 * 0.05 / (kSize / 2.0) * 4 / factor;
    FeedConfig moving = config(1);
    moving.body_paths = {
        Trajectory({{TimeNs{0}, {start, {}}}, {TimeNs{50ms}, {start + Vec3d{to, 0, 0}, {}}}})};
    TilePool pool(1);
    Rig rig(std::make_unique<Feed>(std::make_shared<RenderScene>(std::move(s)), truck(0), moving, pool));
    const std::vector<TimeNs> ends = endsOf(rig, pool, 100ms);
    ASSERT_EQ(ends.size(), 5u) << body;  // 3.1 px in the first frame; then all rests
    EXPECT_NEAR(seconds(ends[0]), 0.0125, 1e-3) << body;
    EXPECT_EQ(rig.lastTimes().total().count(), 0) << body;
  }
}

TEST(RigIntervals, AllocateNothingAfterTheFirstOnes) {
  TilePool pool(1);
  Rig rig(std::make_unique<Feed>(test::room(), truck(0.4, 200ms), config(0.5), pool));
  for (int i = 0; i < 12; ++i) rig.step({pool});
  const int before = test::allocations();
  for (int i = 0; i < 6; ++i) rig.step({pool});
  EXPECT_EQ(test::allocations(), before);
}

TEST(RigIntervals, FollowLampsThatChange) {
  TilePool pool(1);
  const auto scene = test::room(Strength({{0ms, 1}, {30ms, 0}}));
  Rig rig(std::make_unique<Feed>(scene, truck(0), config(1), pool));
  EXPECT_EQ(endsOf(rig, pool, 50ms).size(), 50u);
}

}  // namespace
}  // namespace saccade
