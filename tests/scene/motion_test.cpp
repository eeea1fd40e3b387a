#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/hash_rng.h"
#include "scene/camera/motion.h"
#include "scene/camera/shake.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;

constexpr double kFov = 45;
const Pose kStart{{1, 2, 3}, axisAngle({0.3, -0.8, 0.2})};
constexpr TimeNs kFrame{2'000'000};  // at kMotionRateHz

// Points within the field of view, 4 to 9 away.
std::vector<Vec3d> probes() {
  std::vector<Vec3d> points;
  const auto unit = [](std::uint64_t i, std::uint64_t axis) -> double { return toUnit(hashKey(i, axis)); };
  for (std::uint64_t i = 0; i < 201; ++i) {
    const double z = 4 + 5 * unit(i, 0), half = z * std::tan(kFov * std::numbers::pi / 360);
    const Vec3d seen{half * (2 * unit(i, 1) - 1), half * (2 * unit(i, 2) - 1), z};
    points.push_back(kStart.position + rotate(kStart.rotation, seen));
  }
  return points;
}

Vec2 project(const Pose& camera, Vec3d point) {
  const Pose to_camera = inverse(camera);
  const Vec3d p = to_camera.position + rotate(to_camera.rotation, point);
  const double focal = kMotionWidth / 2 / std::tan(kFov * std::numbers::pi / 360);
  return {static_cast<float>(focal * p.x / p.z), static_cast<float>(focal * p.y / p.z)};
}

// Appends how far each probe's image moves in the frame from t on, in pixels.
void appendSteps(const Trajectory& path, TimeNs t, std::vector<double>& steps) {
  for (const Vec3d p : probes()) {
    const Vec2 a = project(path.at(t), p), b = project(path.at(t + kFrame), p);
    steps.push_back(std::hypot(b.x - a.x, b.y - a.y));
  }
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + std::ssize(values) / 2, values.end());
  return values[values.size() / 2];
}

TEST(Motion, StartsAtTheReferenceSpeed) {
  for (const std::string name : {"right", "forward", "orbit"}) {
    std::vector<double> steps;
    appendSteps(makeMotion(namedMotion(name, kFov), kStart, probes()), TimeNs{0}, steps);
    EXPECT_NEAR(median(steps), kMotionPxPerFrame, 0.01 * kMotionPxPerFrame) << name;
  }
}

TEST(Motion, ShakeHasTheReferenceSpeedOverItsPeriod) {
  const Trajectory path = makeMotion(namedMotion("shake", kFov), kStart, probes());
  std::vector<double> steps;
  for (TimeNs t{0}; t < kShakePeriod; t += 10ms) appendSteps(path, t, steps);
  EXPECT_NEAR(median(steps), kMotionPxPerFrame, 0.01 * kMotionPxPerFrame);
}

TEST(Motion, ShakeStaysNearItsStart) {
  const Trajectory path = makeMotion(namedMotion("shake", kFov), kStart, probes());
  for (TimeNs t{0}; t < kShakePeriod; t += 10ms)
    EXPECT_LT(length(path.at(t).position - kStart.position), 0.05 * 6.5);  // of the median depth
}

TEST(Motion, StillNeverMoves) {
  const Trajectory path = makeMotion(namedMotion("still", kFov), kStart, probes());
  for (const TimeNs t : {TimeNs{0}, TimeNs{1}, kFrame, TimeNs{100s}}) EXPECT_EQ(path.at(t), kStart);
}

TEST(Motion, GoesTheWayItsNameSays) {
  const auto direction = [](const std::string& name) {
    const Vec3d moved =
        makeMotion(namedMotion(name, kFov), kStart, probes()).at(kFrame).position - kStart.position;
    return normalize(rotate(inverse(kStart).rotation, moved));
  };
  expectNear(direction("right"), {1, 0, 0}, 1e-9);
  expectNear(direction("forward"), {0, 0, 1}, 1e-9);
  EXPECT_GT(direction("orbit").x, 0.99);
}

TEST(Motion, TurnsBackAndRepeats) {
  const Trajectory right = makeMotion(namedMotion("right", kFov), kStart, probes());
  EXPECT_EQ(right.at(2 * kTurnTime), kStart);
  expectNear(right.at(kTurnTime + 50ms).position, right.at(kTurnTime - 50ms).position, 1e-12);
  EXPECT_EQ(right.at(40 * kTurnTime + kFrame), right.at(kFrame));
  const Trajectory shake = makeMotion(namedMotion("shake", kFov), kStart, probes());
  EXPECT_EQ(shake.at(TimeNs{0}), kStart);
  EXPECT_EQ(shake.at(3 * kShakePeriod), kStart);
}

TEST(Motion, ForwardKeepsItsDistance) {
  const std::vector<Vec3d> points = probes();
  const Pose to_start = inverse(kStart);
  double nearest = 1e9, farthest = 0;
  for (const Vec3d p : points)
    nearest = std::min(nearest, (to_start.position + rotate(to_start.rotation, p)).z);
  const Trajectory path = makeMotion(namedMotion("forward", kFov), kStart, points);
  for (TimeNs t{0}; t < 1s; t += kFrame)
    farthest = std::max(farthest, length(path.at(t).position - kStart.position));
  EXPECT_LE(farthest, nearest / 4 + 1e-9);
  EXPECT_GT(farthest, nearest / 8);
}

TEST(Motion, OrbitKeepsLookingAtItsPoint) {
  std::vector<Vec3d> points = probes();
  const Vec3d middle = kStart.position + rotate(kStart.rotation, {0, 0, 5});
  points.push_back(middle);
  const Trajectory path = makeMotion(namedMotion("orbit", kFov), kStart, points);
  for (TimeNs t{0}; t < 400ms; t += 20ms) {
    const Vec2 seen = project(path.at(t), middle);
    EXPECT_NEAR(std::hypot(seen.x, seen.y), 0, 1e-3);
  }
}

// Nothing in view, everything behind, a single point straight ahead (which forward and orbit do not move).
TEST(Motion, IsFiniteWhateverIsInView) {
  const Vec3d ahead = kStart.position + rotate(kStart.rotation, {0, 0, 5});
  const Vec3d behind = kStart.position - rotate(kStart.rotation, {0, 0, 5});
  for (const std::vector<Vec3d>& points : {std::vector<Vec3d>{}, {behind}, {ahead}})
    for (const std::string& name : motionNames())
      for (const double fov : {1.0, kFov, 179.0}) {
        const Pose p = makeMotion(namedMotion(name, fov), kStart, points).at(60ms);
        EXPECT_TRUE(length(p.position) < 1000 && std::abs(p.rotation.w) <= 1) << name << " at " << fov;
      }
}

TEST(Motion, NamesAreKnown) {
  for (const std::string& name : motionNames()) EXPECT_TRUE(isMotionName(name));
  EXPECT_FALSE(isMotionName("sideways"));
  EXPECT_EQ(motionNames().size(), 5u);
}

}  // namespace
}  // namespace saccade
