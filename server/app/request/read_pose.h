// Reads vectors and poses of requests.
#pragma once

#include <string>

#include "saccade/v1/control.pb.h"
#include "saccade/wire/ranges.h"
#include "scene/camera/pose.h"

namespace saccade {

// These throw Refusal naming a member of `field`.
Vec3d readVector(const v1::Vector3& v, const Range<double>& range, const std::string& field);
// `field` has the members position, within kMaxDistance, and rotation, of any length that isRotation()
// allows.
Vec3d readPosition(const v1::Vector3& position, const std::string& field);
Quaternion readRotation(const v1::Quaternion& rotation, const std::string& field);
Pose readPose(const v1::Vector3& position, const v1::Quaternion& rotation, const std::string& field);

}  // namespace saccade
