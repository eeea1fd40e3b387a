#include "scene/camera/motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/check.h"
#include "base/names.h"
#include "base/range.h"
#include "scene/camera/random_path.h"
#include "scene/camera/screw_motion.h"
#include "scene/camera/shake.h"

namespace saccade {
namespace {

constexpr double kPi = std::numbers::pi, kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMinSpeed = 1e-6, kMaxSpeed = 1e6;

using Draw = SinePath(const Pose&, const VisiblePoints&, double image_speed, std::uint64_t seed, const Lens&);

// THE list of kinds.
struct Kind {
  std::string name;
  Twist velocity;        // at speed 1: scene units or radians per second; see Screw
  Draw* draw = nullptr;  // of what has no constant velocity
  bool seeded = draw != nullptr;
};
const std::vector<Kind>& kindTable() {
  static const std::vector<Kind> table{{"dolly", {{0, 0, 1}, {}}},     {"truck", {{1, 0, 0}, {}}},
                                       {"pedestal", {{0, -1, 0}, {}}}, {"pan", {{}, {0, 1, 0}}},
                                       {"tilt", {{}, {1, 0, 0}}},      {"roll", {{}, {0, 0, 1}}},
                                       {"orbit", {{}, {0, -1, 0}}},    {"shake", {}, makeShake},
                                       {"random", {}, makeRandomPath}, {kRoam, {}, nullptr, true}};
  return table;
}

Screw makeScrew(const Kind& kind, const VisiblePoints& view) {
  const auto off_axis = [](Vec3d p) { return std::hypot(p.x, p.y) / p.z; };
  const auto more_central = [&](Vec3d a, Vec3d b) { return off_axis(a) < off_axis(b); };
  if (kind.name == "dolly") return {kind.velocity, {}, nearestDepth(view) / 4};
  if (kind.name == "orbit")
    return {kind.velocity, {0, 0, std::min_element(view.begin(), view.end(), more_central)->z}, kMaxOrbitRad};
  return {kind.velocity, {}, kInfinity};
}

// Scene units or radians per second.
double rateOf(const Motion& motion, const Screw& screw, const VisiblePoints& view, const Lens& lens) {
  double rate = motion.speed * (screw.rotates() ? kPi / 180 : 1);
  if (motion.image_speed) {
    const double found = medianImageSpeed(view, screw.twist(), lens);
    rate = found > 0 ? motion.speed / found : 0;
  }
  const double most = screw.rotates() ? kMaxTurnsPerSecond * 2 * kPi : kMaxDistance;
  return std::clamp(rate, -most, most);
}

}  // namespace

const std::vector<std::string>& motionKinds() {
  static const auto names = [] {
    std::vector<std::string> list;
    for (const Kind& kind : kindTable()) list.push_back(kind.name);
    return list;
  }();
  return names;
}

bool isSeeded(const std::string& kind) {
  const Kind* found = findRow(kindTable(), kind);
  return found && found->seeded;
}

std::string speedFault(const std::string& kind, double speed) {
  if (isSeeded(kind)) return rangeFault(speed, kMinSpeed, kMaxSpeed);
  const std::string fault = rangeFault(std::abs(speed), kMinSpeed, kMaxSpeed);
  return fault.empty() ? fault : "of either sign: " + fault;
}

Trajectory makeMotion(const Motion& motion, const Pose& start, const std::vector<Vec3d>& probes,
                      const Lens& lens) {
  const Kind* kind = findRow(kindTable(), motion.kind);
  SACCADE_CHECK(kind && motion.kind != kRoam);
  const VisiblePoints view = viewOf(start, probes);
  if (kind->draw) {
    const double image_speed = motion.image_speed ? motion.speed : motion.speed * kPi / 180;
    return Trajectory(kind->draw(start, view, image_speed, motion.seed, lens));
  }
  const Screw screw = makeScrew(*kind, view);
  const double rate = rateOf(motion, screw, view, lens);
  if (rate == 0) return Trajectory({{TimeNs{0}, start}});
  return motion.turn_s == 0.0 ? onAndOn(screw, start, rate) : thereAndBack(screw, start, rate, motion.turn_s);
}

}  // namespace saccade
