// Paths through the free space of a room that is known in closed form.
#include "scene/roam/roam.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/cancelled.h"
#include "scene/camera/image_speed.h"
#include "scene/room_space.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;
using test::RoomSpace;

constexpr double kDegree = std::numbers::pi / 180, kClearance = 0.3;
constexpr std::uint64_t kSeeds = 12;
const Lens kLens(pinhole(60, 64, 48));
const Pose kStart{{1.5, 1.5, 1.5}, {0, 0, 1, 0}};  // half a turn about the viewing axis: y is up

Motion roam(std::uint64_t seed = 0, std::optional<double> clearance = kClearance, double speed = 20) {
  return {.kind = kRoam, .speed = speed, .seed = seed, .clearance = clearance};
}

Trajectory inRoom(std::uint64_t seed, const RoomSpace& room = {}) {
  return makeRoam(roam(seed), kStart, room, kLens);
}

// f(pose), spread evenly over the path.
template <class F>
void forEachPose(const Trajectory& path, int count, const F& f) {
  for (int i = 0; i < count; ++i) f(path.at(path.lastTime() / count * i));
}

double leastDistance(const Trajectory& path, const RoomSpace& room) {
  double least = 1e9;
  forEachPose(path, 5000,
              [&](const Pose& pose) { least = std::min(least, room.exactDistance(pose.position)); });
  return least;
}

// The points that a camera sees on a grid over its picture, in its axes.
VisiblePoints viewFrom(const Pose& pose, const RoomSpace& room) {
  VisiblePoints view;
  for (float y = 1; y < 48; y += 3)
    for (float x = 1; x < 64; x += 3) {
      const Vec2 p = kLens.planePoint(x, y);
      const Vec3d ray = normalize(Vec3d{p.x, p.y, 1}), along = rotate(pose.rotation, ray);
      double distance = 0;
      room.look(pose.position, {&along, 1}, {&distance, 1});
      if (std::isfinite(distance)) view.push_back(ray * distance);
    }
  return view;
}

TEST(Roam, KeepsTheClearanceAllAlong) {
  const RoomSpace room;
  double closest = 1e9;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const double least = leastDistance(inRoom(seed), room);
    EXPECT_GE(least, kClearance) << seed;
    closest = std::min(closest, least);
  }
  EXPECT_LT(closest, 2 * kClearance);  // not for want of going anywhere
}

// The ball has an inside, to which no line leads from the start.
TEST(Roam, NeverLiesWithinAnObject) {
  const RoomSpace room;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed)
    forEachPose(makeRoam(roam(seed, 0.01), kStart, room, kLens), 500, [&](const Pose& pose) {
      const Vec3d p = pose.position;
      EXPECT_GT(length(p - room.centre), room.radius);
      EXPECT_TRUE(p.x > 0 && p.y > 0 && p.z > 0 && p.x < room.size.x && p.y < room.size.y &&
                  p.z < room.size.z);
    });
}

TEST(Roam, AlwaysSeesSomethingThatIsNotTooNear) {
  const RoomSpace room;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed)
    forEachPose(inRoom(seed), 200, [&](const Pose& pose) {
      const VisiblePoints view = viewFrom(pose, room);
      const auto far = [](Vec3d p) { return length(p) > 0.25; };
      EXPECT_GT(std::ranges::count_if(view, far), 0.4 * 16 * 21) << seed;
    });
}

TEST(Roam, HasTheMedianSpeedThatIsAskedFor) {
  const RoomSpace room;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const Trajectory path = inRoom(seed);
    const TimeNs step = path.lastTime() / 50'000;
    std::vector<double> steps;
    for (int i = 0; i < 500; ++i) {
      const Pose a = path.at(path.lastTime() / 500 * i), b = path.at(path.lastTime() / 500 * i + step);
      appendImageSteps(viewFrom(a, room), {}, inverse(a) * b, kLens, steps);
    }
    std::ranges::sort(steps);
    EXPECT_NEAR(steps[steps.size() / 2] / seconds(step), 20 * kDegree, 0.06 * 20 * kDegree) << seed;
  }
}

TEST(Roam, TurnsWithinItsBoundAndSmoothly) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const Trajectory path = inRoom(seed);
    for (int i = 0; i < 3000; ++i) {
      const TimeNs t = path.lastTime() / 3000 * i;
      const Velocity a = path.velocityAt(t), b = path.velocityAt(t + 10us);
      EXPECT_LT(length(a.angular), 2.2 * 20 * kDegree);
      EXPECT_LT(length(b.linear - a.linear), 0.01) << "a jump of velocity at " << seconds(t);
    }
  }
}

TEST(Roam, IsLevel) {
  forEachPose(inRoom(3), 500, [](const Pose& pose) {
    EXPECT_NEAR(rotate(pose.rotation, {1, 0, 0}).y, 0, 1e-3);
    EXPECT_LT(rotate(pose.rotation, {0, 1, 0}).y, -0.6);
  });
}

TEST(Roam, EverySeedHasAPathOfItsOwnThatRepeats) {
  std::vector<Pose> begins;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Trajectory path = inRoom(seed);
    EXPECT_EQ(path.at(path.lastTime() + 7ms), path.at(7ms));
    const Pose begin = path.at(TimeNs{0});
    for (const Pose& other : begins) EXPECT_GT(length(begin.position - other.position), 1e-3);
    begins.push_back(begin);
  }
  Vec3d least{1e9, 1e9, 1e9}, most{-1e9, -1e9, -1e9};  // they begin all over the room
  for (const Pose& p : begins) {
    least = {std::min(least.x, p.position.x), 0, std::min(least.z, p.position.z)};
    most = {std::max(most.x, p.position.x), 0, std::max(most.z, p.position.z)};
  }
  EXPECT_GT(most.x - least.x, 5);
  EXPECT_GT(most.z - least.z, 3);
}

TEST(Roam, EqualMotionsHaveEqualBits) {
  for (const std::uint64_t seed : {0, 5}) {
    const Trajectory a = inRoom(seed), b = inRoom(seed);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(a.at(i * 31ms), b.at(i * 31ms));
  }
}

TEST(Roam, TheSpeedSetsThePeriodAlone) {
  const RoomSpace room;
  const auto path = [&](double speed) { return makeRoam(roam(1, kClearance, speed), kStart, room, kLens); };
  const Trajectory slow = path(2), quick = path(20);
  EXPECT_NEAR(seconds(slow.lastTime()), 10 * seconds(quick.lastTime()), 1e-7);
  expectNear(slow.at(10s).position, quick.at(1s).position, 1e-6);
  EXPECT_EQ(path(1e6).lastTime(), 10ms);
}

TEST(Roam, WithoutAClearanceTakesOneThatTheStartHasRoomFor) {
  const RoomSpace room;
  EXPECT_GT(leastDistance(makeRoam(roam(0, {}), kStart, room, kLens), room), 0.05);
  const Pose at_wall{{0.02, 1.5, 1.5}, kStart.rotation};
  EXPECT_GT(leastDistance(makeRoam(roam(0, {}), at_wall, room, kLens), room), 0.05);
}

// The fault of a request. Its clearance works, and a half more does not.
TEST(Roam, TellsTheLargestClearanceThatWorks) {
  const RoomSpace room;
  try {
    makeRoam(roam(4, 2.5), kStart, room, kLens);
    FAIL() << "the room is 3 high";
  } catch (const NoRoom& fault) {
    EXPECT_GT(fault.clearance, 0.7);
    EXPECT_LT(fault.clearance, 1.5);
    expectContains(fault.what(), "keeps 2.5");
    EXPECT_GE(leastDistance(makeRoam(roam(4, fault.clearance), kStart, room, kLens), room), fault.clearance);
  }
}

TEST(Roam, StopsWhereItIsTold) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(makeRoam(roam(), kStart, RoomSpace(), kLens, stop.get_token()), Cancelled);
}

TEST(Roam, NeedsSomethingToSee) {
  struct Nothing : FreeSpace {
    double distance(Vec3d, double reach) const override { return reach; }
    void look(Vec3d, std::span<const Vec3d>, std::span<double> distances) const override {
      std::ranges::fill(distances, std::numeric_limits<double>::infinity());
    }
  };
  try {
    makeRoam(roam(), kStart, Nothing(), kLens);
    FAIL() << "there is nothing to see";
  } catch (const NoRoom& fault) {
    EXPECT_EQ(fault.clearance, 0);
  }
}

}  // namespace
}  // namespace saccade
