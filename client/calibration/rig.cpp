#include "client/calibration/rig.h"

#include <algorithm>
#include <cmath>

namespace saccade::client {

Transform bodyFromCamera(const v1::View& view, double scale) {
  const v1::Quaternion& q = view.body_camera().rotation();
  const v1::Vector3& t = view.body_camera().position();
  const double length = std::hypot(std::hypot(q.x(), q.y()), std::hypot(q.z(), q.w()));
  const bool none = length == 0;  // unset
  const double x = none ? 0 : q.x() / length, y = none ? 0 : q.y() / length, z = none ? 0 : q.z() / length,
               w = none ? 1 : q.w() / length;
  return {1 - 2 * (y * y + z * z),
          2 * (x * y - z * w),
          2 * (x * z + y * w),
          scale * t.x(),
          2 * (x * y + z * w),
          1 - 2 * (x * x + z * z),
          2 * (y * z - x * w),
          scale * t.y(),
          2 * (x * z - y * w),
          2 * (y * z + x * w),
          1 - 2 * (x * x + y * y),
          scale * t.z(),
          0,
          0,
          0,
          1};
}

Transform inverse(const Transform& T_a_b) {
  Transform result{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t i = 0; i < 3; ++i) {
      result[4 * row + i] = T_a_b[4 * i + row];
      result[4 * row + 3] -= T_a_b[4 * i + row] * T_a_b[4 * i + 3];
    }
  }
  result[15] = 1;
  return result;
}

Transform relative(const Transform& T_body_a, const Transform& T_body_b) {
  const Transform T_a_body = inverse(T_body_a);
  Transform result{};
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      for (std::size_t i = 0; i < 4; ++i)
        result[4 * row + column] += T_a_body[4 * row + i] * T_body_b[4 * i + column];
  return result;
}

const v1::Truth* imuOf(const v1::OpenStream& stream) {
  const auto& truth = stream.truth();
  const auto at =
      std::find_if(truth.begin(), truth.end(), [](const v1::Truth& t) { return t.name() == "imu"; });
  return at == truth.end() ? nullptr : &*at;
}

double metresPerUnit(const v1::OpenStream& stream) {
  const v1::Truth* imu = imuOf(stream);
  return imu && imu->imu().has_metres_per_unit() ? imu->imu().metres_per_unit() : 1;
}

}  // namespace saccade::client
