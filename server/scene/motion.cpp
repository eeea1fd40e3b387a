#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/check.h"
#include "scene/image_speed.h"
#include "scene/shake.h"
#include "scene/trajectory.h"

namespace saccade {
namespace {

// By how much to multiply this velocity for the images to have `speed`; 0 where it moves none.
double scaleFor(const View& view, const Twist& twist, double speed) {
  const double found = medianImageSpeed(view, twist);
  return found > 0 ? speed / found : 0;
}

// Goes from the start to `far` and back, for ever.
Trajectory thereAndBack(const Pose& start, const Pose& far, double turn_s) {
  const TimeNs turn = std::clamp(TimeNs{std::llround(turn_s * 1e9)}, TimeNs{1'000'000}, kTurnTime);
  return Trajectory::periodic({{TimeNs{0}, start}, {turn, start * far}, {2 * turn, start}});
}

// The time in which `rate` covers `limit`, at most kTurnTime.
double turnTime(double limit, double rate) {
  return rate * seconds(kTurnTime) > limit ? limit / rate : seconds(kTurnTime);
}

Trajectory makeRight(const Pose& start, const View& view, double speed) {
  const double rate = scaleFor(view, {{1, 0, 0}, {}}, speed);
  return thereAndBack(start, {{rate * seconds(kTurnTime), 0, 0}, {}}, seconds(kTurnTime));
}

Trajectory makeForward(const Pose& start, const View& view, double speed) {
  const double rate = scaleFor(view, {{0, 0, 1}, {}}, speed);
  const auto nearest = std::min_element(view.begin(), view.end(), [](Vec3d a, Vec3d b) { return a.z < b.z; });
  const double turn_s = turnTime(nearest->z / 4, rate);
  return thereAndBack(start, {{0, 0, rate * turn_s}, {}}, turn_s);
}

Trajectory makeOrbit(const Pose& start, const View& view, double speed) {
  const auto off_axis = [](Vec3d p) { return std::hypot(p.x, p.y) / p.z; };
  const auto looked_at =
      std::min_element(view.begin(), view.end(), [&](Vec3d a, Vec3d b) { return off_axis(a) < off_axis(b); });
  const Vec3d pivot{0, 0, looked_at->z}, axis{0, -1, 0};  // to the right at first
  const double rate = scaleFor(view, {-cross(axis, pivot), axis}, speed);
  const double turn_s = turnTime(kMaxOrbitRad, rate);
  const Quaternion turned = axisAngle(axis * (rate * turn_s));
  return thereAndBack(start, {pivot - rotate(turned, pivot), turned}, turn_s);
}

Trajectory makeStill(const Pose& start, const View&, double) {
  return Trajectory({{TimeNs{0}, start}});
}

// `speed` is the median speed to give the images, in focal lengths per second.
struct Motion {
  std::string name;
  Trajectory (*make)(const Pose& start, const View& view, double speed);
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
  const double focal_px = kMotionWidth / 2 / std::tan(fov_x_deg * std::numbers::pi / 360);
  return motion->make(start, viewOf(start, probes), kMotionPxPerFrame * kMotionRateHz / focal_px);
}

}  // namespace saccade
