#include "app/request/read_pose.h"

#include "app/request/refusal.h"
#include "scene/camera/trajectory.h"

namespace saccade {

Vec3d readVector(const v1::Vector3& v, const Range<double>& range, const std::string& field) {
  checkRange(field + ".x", v.x(), range);
  checkRange(field + ".y", v.y(), range);
  checkRange(field + ".z", v.z(), range);
  return {v.x(), v.y(), v.z()};
}

Vec3d readPosition(const v1::Vector3& position, const std::string& field) {
  return readVector(position, {-kMaxDistance, kMaxDistance}, field + ".position");
}

Quaternion readRotation(const v1::Quaternion& rotation, const std::string& field) {
  const Quaternion q{rotation.x(), rotation.y(), rotation.z(), rotation.w()};
  if (!isRotation(q))
    refuse(field + ".rotation", "the length of the quaternion x y z w is near 0 or far from 1");
  return q;
}

Pose readPose(const v1::Vector3& position, const v1::Quaternion& rotation, const std::string& field) {
  return {readPosition(position, field), readRotation(rotation, field)};
}

}  // namespace saccade
