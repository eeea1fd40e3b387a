#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/check.h"
#include "base/hash_rng.h"
#include "scene/trajectory.h"

namespace saccade {
namespace {

// Velocity of the camera in its own axes, per second: linear in scene units, angular in radians.
struct Twist {
  Vec3d linear, angular;
};

Vec3d mapPoint(const Pose& pose, Vec3d p) {
  return pose.position + rotate(pose.rotation, p);
}

constexpr double kNear = 1e-6;  // points nearer than this have no image

// What the camera sees, in its own axes: points in front of it.
using View = std::vector<Vec3d>;

View viewOf(const Pose& camera, const std::vector<Vec3>& probes) {
  const Pose to_camera = inverse(camera);
  View view;
  for (const Vec3 probe : probes) {
    const Vec3d p = mapPoint(to_camera, toDouble(probe));
    if (p.z > kNear) view.push_back(p);
  }
  if (view.empty()) view.push_back({0, 0, 1});
  return view;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Speed of the image of p, in focal lengths per second.
double imageSpeed(Vec3d p, const Twist& camera) {
  const Vec3d v = -camera.linear - cross(camera.angular, p);
  return std::hypot(v.x - p.x / p.z * v.z, v.y - p.y / p.z * v.z) / p.z;
}

// The median speed to give the images, in focal lengths per second.
double wantedSpeed(double fov_x_deg) {
  const double focal_px = kMotionWidth / 2 / std::tan(fov_x_deg * std::numbers::pi / 360);
  return kMotionPxPerFrame * kMotionRateHz / focal_px;
}

// The factor that gives this velocity the speed we want; 0 where it moves nothing.
double scaleFor(const View& view, const Twist& twist, double fov_x_deg) {
  std::vector<double> speeds;
  for (const Vec3d p : view) speeds.push_back(imageSpeed(p, twist));
  const double speed = median(std::move(speeds));
  return speed > 0 ? wantedSpeed(fov_x_deg) / speed : 0;
}

// Goes from the start to `far` and back, for ever.
Trajectory thereAndBack(const Pose& start, const Pose& far, double turn_s) {
  const TimeNs turn = std::clamp(TimeNs{std::llround(turn_s * 1e9)}, TimeNs{1'000'000}, kTurnTime);
  return Trajectory::periodic({{TimeNs{0}, start}, {turn, start * far}, {2 * turn, start}});
}

// The time in which `speed` covers `limit`, at most kTurnTime.
double turnTime(double limit, double speed) {
  return speed * seconds(kTurnTime) > limit ? limit / speed : seconds(kTurnTime);
}

Trajectory makeRight(const Pose& start, const View& view, double fov_x_deg) {
  const double speed = scaleFor(view, {{1, 0, 0}, {}}, fov_x_deg);
  return thereAndBack(start, {{speed * seconds(kTurnTime), 0, 0}, {}}, seconds(kTurnTime));
}

Trajectory makeForward(const Pose& start, const View& view, double fov_x_deg) {
  const double speed = scaleFor(view, {{0, 0, 1}, {}}, fov_x_deg);
  const auto nearest = std::min_element(view.begin(), view.end(), [](Vec3d a, Vec3d b) { return a.z < b.z; });
  const double turn_s = turnTime(nearest->z / 4, speed);
  return thereAndBack(start, {{0, 0, speed * turn_s}, {}}, turn_s);
}

Trajectory makeOrbit(const Pose& start, const View& view, double fov_x_deg) {
  const auto off_axis = [](Vec3d p) { return std::hypot(p.x, p.y) / p.z; };
  const Vec3d looked_at = *std::min_element(view.begin(), view.end(),
                                            [&](Vec3d a, Vec3d b) { return off_axis(a) < off_axis(b); });
  const Vec3d pivot{0, 0, looked_at.z}, axis{0, -1, 0};  // to the right at first
  const double speed = scaleFor(view, {-cross(axis, pivot), axis}, fov_x_deg);
  const double turn_s = turnTime(kMaxOrbitRad, speed);
  const Quaternion turned = axisAngle(axis * (speed * turn_s));
  return thereAndBack(start, {pivot - rotate(turned, pivot), turned}, turn_s);
}

// One axis of a hand that shakes: sines of these many cycles in a period, all of the same speed, 0 at the
// start.
double shakeAt(std::uint64_t axis, double t) {
  double sum = 0;
  for (const int cycles : {4, 7, 10, 13, 19}) {
    const double rate = 2 * std::numbers::pi * cycles / seconds(kShakePeriod);
    const double phase = 2 * std::numbers::pi * toUnit(hashKey(axis, static_cast<std::uint64_t>(cycles)));
    sum += (std::sin(rate * t + phase) - std::sin(phase)) / rate;
  }
  return sum;
}

constexpr TimeNs kShakeStep{1'000'000};
constexpr double kShakeTravel =
    0.25;                        // a hand turns more than it travels; weight of translation in the picture
constexpr double kMaxShake = 2;  // keeps the swing below half a radian

// Poses relative to the start, for a picture whose surfaces are `depth` away.
std::vector<Pose> shakePoses(double depth, double scale) {
  std::vector<Pose> poses;
  for (TimeNs time{0}; time < kShakePeriod; time += kShakeStep) {
    const auto at = [&](std::uint64_t axis) { return scale * shakeAt(axis, seconds(time)); };
    poses.push_back({Vec3d{at(0), at(1), at(2)} * (kShakeTravel * depth), axisAngle({at(3), at(4), at(5)})});
  }
  return poses;
}

double medianImageSpeed(const View& view, const std::vector<Pose>& poses, double step_s) {
  constexpr std::size_t kStride = 10;  // enough to know the median
  std::vector<double> speeds;
  for (std::size_t i = 0; i + 1 < poses.size(); i += kStride) {
    const Pose before = inverse(poses[i]), after = inverse(poses[i + 1]);
    for (const Vec3d p : view) {
      const Vec3d a = mapPoint(before, p), b = mapPoint(after, p);
      if (a.z < kNear || b.z < kNear) continue;
      speeds.push_back(std::hypot(b.x / b.z - a.x / a.z, b.y / b.z - a.y / a.z) / step_s);
    }
  }
  return median(std::move(speeds));
}

Trajectory makeShake(const Pose& start, const View& view, double fov_x_deg) {
  std::vector<double> depths;
  for (const Vec3d p : view) depths.push_back(p.z);
  const double depth = median(std::move(depths));
  // Speed is nearly proportional to the scale, so that a few corrections find it.
  double scale = 0.01;
  for (int i = 0; i < 5; ++i)
    scale = std::min(kMaxShake, scale * wantedSpeed(fov_x_deg) /
                                    medianImageSpeed(view, shakePoses(depth, scale), seconds(kShakeStep)));
  std::vector<TimedPose> keys;
  for (const Pose& pose : shakePoses(depth, scale))
    keys.push_back({std::ssize(keys) * kShakeStep, start * pose});
  keys.push_back({kShakePeriod, keys.front().pose});
  return Trajectory::periodic(std::move(keys));
}

Trajectory makeStill(const Pose& start, const View&, double) {
  return Trajectory({{TimeNs{0}, start}});
}

struct Motion {
  std::string name;
  Trajectory (*make)(const Pose& start, const View& view, double fov_x_deg);
};

// THE list of motions.
const std::vector<Motion>& motionTable() {
  static const std::vector<Motion> table{{"right", makeRight},
                                         {"forward", makeForward},
                                         {"orbit", makeOrbit},
                                         {"shake", makeShake},
                                         {"still", makeStill}};
  return table;
}

}  // namespace

const std::vector<std::string>& motionNames() {
  static const auto names = [] {
    std::vector<std::string> list;
    for (const Motion& motion : motionTable()) list.push_back(motion.name);
    return list;
  }();
  return names;
}

bool isMotion(const std::string& name) {
  return std::find(motionNames().begin(), motionNames().end(), name) != motionNames().end();
}

Trajectory makeMotion(const std::string& name, const Pose& start, const std::vector<Vec3>& probes,
                      double fov_x_deg) {
  const auto motion = std::find_if(motionTable().begin(), motionTable().end(),
                                   [&](const Motion& m) { return m.name == name; });
  SACCADE_CHECK(motion != motionTable().end());
  return motion->make(start, viewOf(start, probes), fov_x_deg);
}

}  // namespace saccade
