#include <cmath>

#include "app/request/read_pose.h"
#include "app/request/refusal.h"
#include "app/request/resolve_trajectory.h"

namespace saccade {
namespace {

constexpr double kMaxKeySeconds = 1e9;

TimedPose readKey(const v1::Keyframe& key, const std::string& field) {
  checkRange(field + ".time_s", key.time_s(), -kMaxKeySeconds, kMaxKeySeconds);
  return {TimeNs{std::llround(key.time_s() * 1e9)}, readPose(key.position(), key.rotation(), field)};
}

}  // namespace

Trajectory resolveKeyframes(const v1::Keyframes& keyframes) {
  std::vector<TimedPose> keys;
  for (const v1::Keyframe& given : keyframes.keys()) {
    const std::string field = "trajectory.keyframes.keys[" + std::to_string(keys.size()) + "]";
    TimedPose key = readKey(given, field);
    if (!keys.empty() && key.time <= keys.back().time)
      refuse(field + ".time_s", "is not later than the time of the key before");
    key.pose.rotation =
        unitNear(key.pose.rotation, keys.empty() ? key.pose.rotation : keys.back().pose.rotation);
    keys.push_back(key);
  }
  const bool cubic = keyframes.interpolation() == v1::INTERPOLATION_CUBIC;
  return Trajectory(std::move(keys), cubic ? Interpolation::kCubic : Interpolation::kLinear);
}

}  // namespace saccade
