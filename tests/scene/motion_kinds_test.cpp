// Each kind of motion against its closed form.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/camera/motion.h"
#include "scene/camera/shake.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;

constexpr double kDegree = std::numbers::pi / 180, kDistance = 4;
const Pose kStart{{1, 2, 3}, axisAngle({0.3, -0.8, 0.2})};

// One surface point straight ahead.
const std::vector<Vec3d> kAhead{kStart.position + rotate(kStart.rotation, {0, 0, kDistance})};

Trajectory make(const std::string& kind, double speed, std::optional<double> turn_s = {},
                std::uint64_t seed = 0) {
  return makeMotion({.kind = kind, .speed = speed, .turn_s = turn_s, .seed = seed}, kStart, kAhead);
}

// In the axes of the start.
Pose relative(const Trajectory& path, TimeNs t) {
  return inverse(kStart) * path.at(t);
}

TEST(MotionKinds, LinearOnesGoTheirWayAtTheirSpeed) {
  const struct {
    std::string kind;
    Vec3d way;
  } cases[] = {{"dolly", {0, 0, 1}}, {"truck", {1, 0, 0}}, {"pedestal", {0, -1, 0}}};
  for (const auto& [kind, way] : cases) {
    for (const double speed : {0.5, -3.0}) {
      for (const TimeNs t : {1ms, 50ms, 200ms}) {
        const Pose p = relative(make(kind, speed, 0.2), t);
        expectNear(p.position, way * (speed * seconds(t)), 1e-12);
        expectNear(rotationVector(p.rotation), {0, 0, 0}, 1e-12);
      }
    }
  }
}

// The camera's view in its middle, and to its right, after a turn to the right, up, or clockwise.
TEST(MotionKinds, RotationsTurnByTheirAngle) {
  for (const double speed : {15.0, -40.0}) {
    for (const TimeNs t : {1ms, 100ms, 200ms}) {
      const double a = speed * seconds(t) * kDegree;
      const auto turned = [&](const std::string& kind) { return relative(make(kind, speed), t); };
      expectNear(rotate(turned("pan").rotation, {0, 0, 1}), {std::sin(a), 0, std::cos(a)}, 1e-9);
      expectNear(rotate(turned("tilt").rotation, {0, 0, 1}), {0, -std::sin(a), std::cos(a)}, 1e-9);
      expectNear(rotate(turned("roll").rotation, {1, 0, 0}), {std::cos(a), std::sin(a), 0}, 1e-9);
      for (const char* kind : {"pan", "tilt", "roll"}) expectNear(turned(kind).position, {0, 0, 0}, 1e-9);
    }
  }
}

TEST(MotionKinds, OrbitGoesRoundThePointLookedAt) {
  for (const double speed : {60.0, -60.0}) {
    const Trajectory path = make("orbit", speed, 0);
    for (const TimeNs t : {10ms, 1000ms, 2000ms, 7777ms}) {
      const double a = speed * seconds(t) * kDegree;  // the camera goes right and turns left
      expectNear(relative(path, t).position, {kDistance * std::sin(a), 0, kDistance * (1 - std::cos(a))},
                 1e-6);
      expectNear(rotate(relative(path, t).rotation, {0, 0, 1}), {-std::sin(a), 0, std::cos(a)}, 1e-6);
    }
  }
}

TEST(MotionKinds, TurnBackWhenTheyAreTold) {
  for (const std::string& kind : motionKinds()) {
    if (isSeeded(kind)) continue;
    const Trajectory path = make(kind, 700, 1);  // of rotations, nearly two turns
    EXPECT_EQ(path.at(2s), kStart) << kind;
    expectNear(path.at(1300ms).position, path.at(700ms).position, 1e-9);
    expectNear(rotate(path.at(1300ms).rotation, {1, 2, 3}), rotate(path.at(700ms).rotation, {1, 2, 3}), 1e-9);
    expectNear(path.at(4s + 300ms).position, path.at(300ms).position, 1e-9);
  }
  expectNear(relative(make("truck", 2, 3), 3s).position, {6, 0, 0}, 1e-12);
  const double a = 700 * 0.9 * kDegree;
  expectNear(rotate(relative(make("pan", 700, 1), 900ms).rotation, {0, 0, 1}), {std::sin(a), 0, std::cos(a)},
             1e-9);
}

TEST(MotionKinds, TurnBackByThemselvesBeforeTheyLeaveTheScene) {
  EXPECT_EQ(make("truck", 100).at(2 * kTurnTime), kStart);
  EXPECT_EQ(make("dolly", 1).at(2 * kTurnTime), kStart);
  // A quarter of the way to the surface takes 100 ms.
  expectNear(relative(make("dolly", 10), 100ms).position, {0, 0, 1}, 1e-6);
  expectNear(relative(make("dolly", 10), 150ms).position, {0, 0, 0.5}, 1e-6);
  expectNear(relative(make("dolly", -10), 100ms).position, {0, 0, -1}, 1e-6);
  const TimeNs turn{std::llround(1e9 * kMaxOrbitRad / (100 * kDegree))};
  EXPECT_EQ(make("orbit", 100).at(2 * turn), kStart);
  EXPECT_NEAR(length(rotationVector(relative(make("orbit", 100), turn).rotation)), kMaxOrbitRad, 1e-9);
}

TEST(MotionKinds, GoOnForEverWhenTheyAreTold) {
  expectNear(relative(make("dolly", 0.25, 0), 1000s).position, {0, 0, 250}, 1e-9);
  const Trajectory pan = make("pan", -30, 0);  // a turn takes 12 s
  for (const TimeNs t : {1s, 5s, 11s, 12s, 12s * 100'000 + 5s}) {
    const double a = -30 * std::fmod(seconds(t), 12) * kDegree;
    expectNear(rotate(relative(pan, t).rotation, {0, 0, 1}), {std::sin(a), 0, std::cos(a)}, 1e-9);
  }
}

TEST(MotionKinds, ASpeedOfTheImagesIsThatOfTheMedianPoint) {
  // Of points at depth 4 one moves by 1/4 focal length for each unit that the camera goes right.
  Motion truck{.kind = "truck", .speed = 0.5, .image_speed = true};
  expectNear(relative(makeMotion(truck, kStart, kAhead), 100ms).position, {0.2, 0, 0}, 1e-6);
  truck.speed = -0.5;
  expectNear(relative(makeMotion(truck, kStart, kAhead), 100ms).position, {-0.2, 0, 0}, 1e-6);
  const Motion dolly{.kind = "dolly", .speed = 0.5, .image_speed = true};  // moves no point on its axis
  EXPECT_EQ(makeMotion(dolly, {}, {{0, 0, 4}}).at(150us), Pose{});
}

// An equidistant lens shows angles: a pan moves the whole horizon by the angle that it turns.
TEST(MotionKinds, ASpeedOfTheImagesIsThatThroughTheLens) {
  const Lens lens({.width = 200,
                   .height = 1,
                   .fx = 100,
                   .fy = 100,
                   .cx = 99.5,
                   .distortion = {LensModel::kEquidistant, {}}});
  const Motion pan{.kind = "pan", .speed = 0.5, .image_speed = true};
  const std::vector<Vec3d> aside{{1.6, 0, 2}};  // a pinhole would show it moving 1.64 times as fast
  const Trajectory path = makeMotion(pan, {}, aside, lens);
  expectNear(rotationVector(path.at(100ms).rotation), {0, 0.05, 0}, 1e-9);
}

TEST(MotionKinds, ShakeHasItsSpeedAndItsSeed) {
  const auto at = [](double speed, std::uint64_t seed) { return make("shake", speed, {}, seed).at(123ms); };
  EXPECT_EQ(at(2, 5), at(2, 5));
  EXPECT_NE(at(2, 5), at(2, 6));
  EXPECT_NE(at(2, 0), at(2, 1));
  std::vector<double> speeds;
  const Trajectory path = make("shake", 2, {}, 5);
  for (TimeNs t{0}; t < kShakePeriod; t += 5ms) {
    const auto image = [&](TimeNs time) {
      const Pose camera = inverse(path.at(time));
      const Vec3d p = camera.position + rotate(camera.rotation, kAhead[0]);
      return Vec3d{p.x / p.z, p.y / p.z, 0};
    };
    speeds.push_back(length(image(t + 1ms) - image(t)) / 1e-3);
  }
  std::sort(speeds.begin(), speeds.end());
  EXPECT_NEAR(speeds[speeds.size() / 2], 2 * kDegree, 0.02 * 2 * kDegree);
}

TEST(MotionKinds, AreFiniteHoweverFastAndLong) {
  for (const std::string& kind : motionKinds()) {
    if (kind == kRoam) continue;  // not of makeMotion()
    for (const double speed : {1e-6, 1e6})
      for (const bool image_speed : {false, true})
        for (const std::optional<double> turn_s : {std::optional<double>{}, {0.0}, {1e-3}, {1e3}}) {
          const Motion motion{.kind = kind, .speed = speed, .image_speed = image_speed, .turn_s = turn_s};
          const Trajectory path = makeMotion(motion, kStart, kAhead);
          for (const TimeNs t : {TimeNs{1}, TimeNs{3ms}, TimeNs{1h}, TimeNs{24h * 365 * 100}}) {
            const Pose p = path.at(t);
            EXPECT_TRUE(length(p.position) < 2e9 && std::abs(p.rotation.w) <= 1 + 1e-9)
                << kind << ' ' << speed;
          }
        }
  }
}

TEST(ParseMotion, ReadsKindAndSpeed) {
  EXPECT_EQ(parseMotion("pan:-15")->kind, "pan");
  EXPECT_EQ(parseMotion("pan:-15")->speed, -15);
  EXPECT_EQ(parseMotion("dolly:2e-1")->speed, 0.2);
  EXPECT_FALSE(parseMotion("right"));
  expectContains(errorOf([] { parseMotion("fly:1"); }), "'fly' is not a motion; there are: dolly, truck");
  for (const std::string text : {"pan:", "pan:fast", "pan:1:2", "pan:nan"})
    expectContains(errorOf([&] { parseMotion(text); }), "'" + text + "' is not KIND:SPEED");
  expectContains(errorOf([] { parseMotion("pan:0"); }), "of either sign: 0 is outside");
  expectContains(errorOf([] { parseMotion("shake:-2"); }), "shake:-2: -2 is outside");
  expectContains(errorOf([] { parseMotion("random:-2"); }), "random:-2: -2 is outside");
}

}  // namespace
}  // namespace saccade
