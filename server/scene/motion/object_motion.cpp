#include "scene/motion/object_motion.h"

#include <array>
#include <cmath>
#include <numbers>

#include "base/check.h"
#include "base/names.h"
#include "base/range.h"
#include "scene/camera/screw_motion.h"
#include "scene/files/scene_error.h"
#include "scene/files/text.h"
#include "scene/shape_box.h"

namespace saccade {
namespace {

constexpr double kMinSpeed = 1e-6, kMaxSpeed = 1e6;
constexpr std::array<Vec3d, 3> kAxes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

// The axis nearest to a direction, either way along it, but not the one numbered `other`.
struct NearestAxis {
  NearestAxis(Vec3d direction, std::size_t other = kAxes.size()) {
    double most = -1;
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
      const double along = dot(kAxes[i], direction);
      if (i == other || std::abs(along) <= most) continue;
      most = std::abs(along), number = i, sign = along < 0 ? -1 : 1;
    }
  }
  Vec3d vector() const { return kAxes[number] * sign; }

  std::size_t number = 0;
  double sign = 1;
};

Vec3d middleOf(const Scene& scene) {
  return toDouble(boxOf(scene).centre()) + scene.origin;
}

Trajectory pendulum(const Pose& start, const NearestAxis& along, double speed) {
  const double amplitude = speed * seconds(kSwingTime) / (2 * std::numbers::pi);
  SinePath path{start, kSwingTime, {}};
  path.axes[along.number].sines = {{along.sign * amplitude, 1, 0}};
  return Trajectory(std::move(path));
}

}  // namespace

const std::vector<std::string>& objectMotionKinds() {
  static const std::vector<std::string> kinds{"spin", "orbit", "slide", "swing"};
  return kinds;
}

std::string objectSpeedFault(double speed) {
  const std::string fault = rangeFault(std::abs(speed), kMinSpeed, kMaxSpeed);
  return fault.empty() ? fault : "of either sign: " + fault;
}

std::optional<ObjectMotion> parseObjectMotion(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == text.npos) return {};
  const std::string kind = text.substr(0, colon);
  const auto& kinds = objectMotionKinds();
  if (std::ranges::find(kinds, kind) == kinds.end())
    throw SceneError("'" + kind + "' is not a motion of an object; there are: " + joinNames(kinds));
  const auto speed = parseNumber(std::string_view(text).substr(colon + 1));
  if (!speed) throw SceneError("'" + text + "' is not KIND:SPEED, such as spin:90 or slide:-0.5");
  if (const std::string fault = objectSpeedFault(*speed); !fault.empty())
    throw SceneError(text + ": " + fault);
  return ObjectMotion{kind, *speed};
}

Trajectory makeObjectMotion(const ObjectMotion& motion, const Scene& scene, const Body& body) {
  const Quaternion view = scene.T_world_camera.rotation;
  const NearestAxis up(rotate(view, {0, -1, 0})), right(rotate(view, {1, 0, 0}), up.number);
  const Pose start{toDouble(body.centre()) + scene.origin, {}};
  if (motion.kind == "swing") return pendulum(start, right, motion.speed);
  if (motion.kind == "slide")
    return thereAndBack({{right.vector(), {}}, {}, 0}, start, motion.speed, seconds(kSlideTime));
  SACCADE_CHECK(motion.kind == "spin" || motion.kind == "orbit");
  const Vec3d pivot = motion.kind == "spin" ? Vec3d{} : middleOf(scene) - start.position;
  const double rate = motion.speed * std::numbers::pi / 180;
  return onAndOn({{{}, up.vector()}, pivot, 0}, start, rate);
}

}  // namespace saccade
