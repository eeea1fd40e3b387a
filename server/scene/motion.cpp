#include <algorithm>
#include <array>
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

// What the camera sees, in its own axes: points in front of it.
using View = std::vector<Vec3d>;

View viewOf(const Pose& camera, const std::vector<Vec3>& probes) {
  const Pose to_camera = inverse(camera);
  View view;
  for (const Vec3 probe : probes) {
    const Vec3d p = to_camera.position + rotate(to_camera.rotation, toDouble(probe));
    if (p.z > 0) view.push_back(p);
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

double medianImageSpeed(const View& view, const std::vector<Twist>& twists) {
  std::vector<double> speeds;
  for (const Twist& twist : twists)
    for (const Vec3d p : view) speeds.push_back(imageSpeed(p, twist));
  return median(std::move(speeds));
}

// The factor that gives these velocities the speed we want.
double scaleFor(const View& view, const std::vector<Twist>& twists, double fov_x_deg) {
  const double focal_px = kMotionWidth / 2 / std::tan(fov_x_deg * std::numbers::pi / 360);
  const double speed = medianImageSpeed(view, twists) * focal_px;
  return speed > 0 ? kMotionPxPerFrame * kMotionRateHz / speed : 0;
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
  const double speed = scaleFor(view, {{{1, 0, 0}, {}}}, fov_x_deg);
  return thereAndBack(start, {{speed * seconds(kTurnTime), 0, 0}, {}}, seconds(kTurnTime));
}

Trajectory makeForward(const Pose& start, const View& view, double fov_x_deg) {
  const double speed = scaleFor(view, {{{0, 0, 1}, {}}}, fov_x_deg);
  const auto nearest = std::min_element(view.begin(), view.end(), [](Vec3d a, Vec3d b) { return a.z < b.z; });
  const double turn_s = turnTime(nearest->z / 4, speed);
  return thereAndBack(start, {{0, 0, speed * turn_s}, {}}, turn_s);
}

Trajectory makeOrbit(const Pose& start, const View& view, double fov_x_deg) {
  const auto off_axis = [](Vec3d p) { return std::hypot(p.x, p.y) / p.z; };
  const Vec3d looked_at = *std::min_element(view.begin(), view.end(),
                                            [&](Vec3d a, Vec3d b) { return off_axis(a) < off_axis(b); });
  const Vec3d pivot{0, 0, looked_at.z}, axis{0, -1, 0};  // to the right at first
  const double speed = scaleFor(view, {{-cross(axis, pivot), axis}}, fov_x_deg);
  const double turn_s = turnTime(kMaxOrbitRad, speed);
  const Quaternion turned = axisAngle(axis * (speed * turn_s));
  return thereAndBack(start, {pivot - rotate(turned, pivot), turned}, turn_s);
}

// One axis of a hand that shakes: sines of these many cycles in a period, all of the same speed.
constexpr std::array kShakeCycles{1, 3, 4, 7, 10};

struct Wave {
  double value, speed;
};

Wave shakeWave(std::uint64_t axis, double t) {
  Wave wave{0, 0};
  for (const int cycles : kShakeCycles) {
    const double rate = 2 * std::numbers::pi * cycles / seconds(kShakePeriod);
    const double phase = 2 * std::numbers::pi * toUnit(hashKey(axis, static_cast<std::uint64_t>(cycles)));
    wave.value += (std::sin(rate * t + phase) - std::sin(phase)) / rate;
    wave.speed += std::cos(rate * t + phase);
  }
  return wave;
}

// Translation (in units of `depth`) and rotation weigh alike in the picture.
Trajectory makeShake(const Pose& start, const View& view, double fov_x_deg) {
  constexpr TimeNs kStep{1'000'000};
  std::vector<double> depths;
  for (const Vec3d p : view) depths.push_back(p.z);
  const double depth = median(std::move(depths));
  std::vector<Twist> offsets, speeds;
  for (TimeNs time{0}; time < kShakePeriod; time += kStep) {
    std::array<Wave, 6> w;
    for (std::size_t axis = 0; axis < 6; ++axis) w[axis] = shakeWave(axis, seconds(time));
    offsets.push_back(
        {Vec3d{w[0].value, w[1].value, w[2].value} * depth, {w[3].value, w[4].value, w[5].value}});
    if (time % (16 * kStep) == TimeNs{0})
      speeds.push_back(
          {Vec3d{w[0].speed, w[1].speed, w[2].speed} * depth, {w[3].speed, w[4].speed, w[5].speed}});
  }
  const double scale = scaleFor(view, speeds, fov_x_deg);
  std::vector<TimedPose> keys;
  for (const Twist& o : offsets)
    keys.push_back({std::ssize(keys) * kStep, start * Pose{o.linear * scale, axisAngle(o.angular * scale)}});
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
