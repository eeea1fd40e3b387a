// The motions that a seed draws: what a hand can do, and random paths.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/camera/motion.h"
#include "scene/camera/random_path.h"
#include "scene/camera/shake.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;

constexpr double kDegree = std::numbers::pi / 180, kHalfView = 0.4;  // tangent of half the field of view
const Pose kStart{{1, 2, 3}, axisAngle({0.3, -0.8, 0.2})};

// The view of a sphere about the start, from `pose`.
VisiblePoints sphereFrom(const Pose& pose, double radius) {
  VisiblePoints view;
  const Vec3d middle = rotate(conjugate(pose.rotation), kStart.position - pose.position);
  for (int i = -4; i <= 4; ++i)
    for (int k = -3; k <= 3; ++k) {
      const Vec3d d = normalize(Vec3d{kHalfView * i / 4, kHalfView * k / 4, 1});
      const double b = dot(d, middle);
      view.push_back(d * (b + std::sqrt(b * b - dot(middle, middle) + radius * radius)));
    }
  return view;
}

// The least depth of the sphere that the start sees: that of a corner of the view.
double nearestIn(double radius) {
  return radius / std::sqrt(1 + kHalfView * kHalfView * (1 + 0.75 * 0.75));
}

Trajectory seeded(const std::string& kind, double speed, std::uint64_t seed = 0, double radius = 5) {
  std::vector<Vec3d> probes;
  for (const Vec3d p : sphereFrom(kStart, radius))
    probes.push_back(kStart.position + rotate(kStart.rotation, p));
  return makeMotion({.kind = kind, .speed = speed, .seed = seed}, kStart, probes);
}

// The greatest acceleration, by second differences of the positions at 1000 Hz.
double greatestAcceleration(const Trajectory& path, TimeNs span) {
  double greatest = 0;
  for (TimeNs t{0}; t < span; t += 1ms) {
    const Vec3d a = path.at(t).position, b = path.at(t + 1ms).position, c = path.at(t + 2ms).position;
    greatest = std::max(greatest, length(a - b * 2.0 + c) / 1e-6);
  }
  return greatest;
}

double farthest(const Trajectory& path) {
  double distance = 0;
  for (int i = 0; i < 500; ++i)
    distance = std::max(distance, length(path.at(path.lastTime() / 500 * i).position - kStart.position));
  return distance;
}

TEST(Shake, HasTheAccelerationOfAHandAtAnySpeed) {
  for (const double radius : {0.1, 5.0, 1000.0})
    for (const double speed : {0.1, 2.0, 10.0, 60.0, 200.0, 1e6})
      EXPECT_LE(greatestAcceleration(seeded("shake", speed, 3, radius), kShakePeriod),
                kMaxShakeAcceleration * 1.001)
          << speed << " in a sphere of " << radius;
  EXPECT_GT(greatestAcceleration(seeded("shake", 10), kShakePeriod), 0.5);
  EXPECT_GT(greatestAcceleration(seeded("shake", 60), kShakePeriod), kMaxShakeAcceleration / 2);
}

// The velocity has no jumps, so that a faster IMU reads no more.
TEST(Shake, IsSmooth) {
  const Trajectory path = seeded("shake", 30);
  for (TimeNs t{0}; t < kShakePeriod; t += 1ms) {
    const Velocity a = path.velocityAt(t), b = path.velocityAt(t + 50us);
    EXPECT_LE(length(b.linear - a.linear), 1.001 * kMaxShakeAcceleration * 50e-6);
  }
}

TEST(Shake, MovesByCentimetresAndKeepsItsDistance) {
  EXPECT_GT(farthest(seeded("shake", 10)), 1e-3);
  EXPECT_LT(farthest(seeded("shake", 10)), 0.05);
  EXPECT_LT(farthest(seeded("shake", 1e6, 0, 1000)), 0.15);
  EXPECT_LE(farthest(seeded("shake", 1e6, 0, 0.1)), kMaxShakeReach * nearestIn(0.1));
}

// The median speed of the image, by what is in view along the path.
double medianSpeed(const Trajectory& path, double radius) {
  std::vector<double> speeds;
  const TimeNs step = path.lastTime() / 10'000;
  for (int i = 0; i < 500; ++i) {
    const TimeNs t = path.lastTime() / 500 * i;
    const Pose move = inverse(path.at(t + step)) * path.at(t);
    for (const Vec3d p : sphereFrom(path.at(t), radius)) {
      const Vec3d q = move.position + rotate(move.rotation, p);
      speeds.push_back(std::hypot(q.x / q.z - p.x / p.z, q.y / q.z - p.y / p.z) / seconds(step));
    }
  }
  std::sort(speeds.begin(), speeds.end());
  return speeds[speeds.size() / 2];
}

// A random path comes nearer to the sphere and goes away from it, which its speed does not know.
TEST(SeededMotions, HaveTheMedianSpeedThatIsAskedFor) {
  for (const std::uint64_t seed : {0, 1, 2}) {
    EXPECT_NEAR(medianSpeed(seeded("random", 12, seed), 5), 12 * kDegree, 0.04 * 12 * kDegree) << seed;
    EXPECT_NEAR(medianSpeed(seeded("shake", 12, seed), 5), 12 * kDegree, 0.02 * 12 * kDegree) << seed;
  }
}

TEST(RandomPath, StaysWithinItsBounds) {
  double reach = 0, aside = 0, up = 0, rolled = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Trajectory path = seeded("random", 10, seed);
    for (int i = 0; i < 200; ++i) {
      const Pose p = inverse(kStart) * path.at(path.lastTime() / 200 * i);
      const Vec3d ahead = rotate(p.rotation, {0, 0, 1}), right = rotate(p.rotation, {1, 0, 0});
      reach = std::max(reach, length(p.position));
      aside = std::max(aside, std::abs(std::atan2(ahead.x, ahead.z)));
      up = std::max(up, std::abs(std::asin(ahead.y)));
      const Vec3d level{std::cos(std::atan2(ahead.x, ahead.z)), 0, -std::sin(std::atan2(ahead.x, ahead.z))};
      rolled = std::max(rolled, std::acos(std::min(1.0, dot(level, right))));
    }
  }
  const auto fills = [](double found, double bound) { return found <= bound + 1e-9 && found > bound / 2; };
  EXPECT_TRUE(fills(reach, kMaxRandomReach * nearestIn(5))) << reach;
  EXPECT_TRUE(fills(aside, kMaxRandomPan)) << aside;
  EXPECT_TRUE(fills(up, kMaxRandomTilt)) << up;
  EXPECT_TRUE(fills(rolled, kMaxRandomRoll)) << rolled;
}

TEST(RandomPath, EverySeedBeginsElsewhereAndGoesItsOwnWay) {
  std::vector<Pose> starts;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Trajectory path = seeded("random", 10, seed);
    EXPECT_EQ(path.at(path.lastTime() + 7ms), path.at(7ms));
    for (const Pose& other : starts) {
      EXPECT_GT(length(path.at(TimeNs{0}).position - other.position), 1e-3);
      EXPECT_NE(path.at(TimeNs{0}).rotation, other.rotation);
    }
    starts.push_back(path.at(TimeNs{0}));
    EXPECT_GT(farthest(path), 3 * farthest(seeded("shake", 10, seed)));
  }
  EXPECT_EQ(seeded("random", 10, 4).at(1s), seeded("random", 10, 4).at(1s));
}

// A quicker path goes the same way.
TEST(RandomPath, TheSpeedSetsThePeriodAlone) {
  const Trajectory slow = seeded("random", 2), quick = seeded("random", 20);
  EXPECT_NEAR(seconds(slow.lastTime()), 10 * seconds(quick.lastTime()), 1e-8);
  expectNear(slow.at(10s).position, quick.at(1s).position, 1e-6);
  EXPECT_EQ(seeded("random", 1e6).lastTime(), kMinRandomPeriod);
}

}  // namespace
}  // namespace saccade
