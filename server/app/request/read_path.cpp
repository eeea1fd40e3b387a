#include "app/request/read_path.h"

#include <cmath>

#include "app/request/enum_names.h"
#include "app/request/read_pose.h"
#include "app/request/refusal.h"
#include "scene/files/scene_error.h"

namespace saccade {
namespace {

constexpr double kMaxKeySeconds = 1e9;

TimedPose readKey(const v1::Keyframe& key, const std::string& field) {
  checkRange(field + ".time_s", key.time_s(), -kMaxKeySeconds, kMaxKeySeconds);
  return {TimeNs{std::llround(key.time_s() * 1e9)}, readPose(key.position(), key.rotation(), field)};
}

std::vector<TimedPose> readKeys(const v1::Keyframes& keyframes, const std::string& list) {
  std::vector<TimedPose> keys;
  for (const v1::Keyframe& given : keyframes.keys()) {
    const std::string field = list + "[" + std::to_string(keys.size()) + "]";
    TimedPose key = readKey(given, field);
    if (!keys.empty() && key.time <= keys.back().time)
      refuse(field + ".time_s", "is not later than the time of the key before");
    key.pose.rotation =
        unitNear(key.pose.rotation, keys.empty() ? key.pose.rotation : keys.back().pose.rotation);
    keys.push_back(key);
  }
  return keys;
}

}  // namespace

Trajectory readKeyframes(v1::Keyframes& keyframes, const std::string& field) {
  keyframes.set_interpolation(
      resolveEnum(field + ".interpolation", keyframes.interpolation(), v1::INTERPOLATION_LINEAR));
  if (keyframes.keys_size() < 1 || keyframes.keys_size() > ranges::kKeyframes.max)
    refuse(field + ".keys", "give 1 to " + std::to_string(ranges::kKeyframes.max) + " keys");
  const bool cubic = keyframes.interpolation() == v1::INTERPOLATION_CUBIC;
  return Trajectory(readKeys(keyframes, field + ".keys"),
                    cubic ? Interpolation::kCubic : Interpolation::kLinear);
}

PoseText readCsv(const std::string& csv, const std::string& field) {
  if (csv.size() > ranges::kMaxCsvBytes)
    refuse(field, "the text is longer than " + std::to_string(ranges::kMaxCsvBytes) + " bytes");
  try {
    return readPoses(csv, "");
  } catch (const SceneError& fault) {
    refuse(field, fault.what());
  }
}

}  // namespace saccade
