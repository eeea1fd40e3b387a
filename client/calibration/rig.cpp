#include "client/calibration/rig.h"

#include <algorithm>
#include <cmath>

#include "client/calibration/rotation.h"

namespace saccade::client {

Transform bodyFromCamera(const v1::View& view, double scale) {
  const v1::Quaternion& q = view.body_camera().rotation();
  const v1::Vector3& t = view.body_camera().position();
  const double length = std::hypot(std::hypot(q.x(), q.y()), std::hypot(q.z(), q.w()));
  const bool none = length == 0;  // unset
  const Matrix3 r = none ? matrixOf({0, 0, 0, 1})
                         : matrixOf({q.x() / length, q.y() / length, q.z() / length, q.w() / length});
  return {r[0][0], r[0][1], r[0][2], scale * t.x(),  //
          r[1][0], r[1][1], r[1][2], scale * t.y(),  //
          r[2][0], r[2][1], r[2][2], scale * t.z(),  //
          0,       0,       0,       1};
}

v1::RigidTransform rigidTransform(const Transform& m, double scale) {
  v1::RigidTransform out;
  v1::Vector3& t = *out.mutable_position();
  t.set_x(scale * m[3]), t.set_y(scale * m[7]), t.set_z(scale * m[11]);
  const Quaternion q = quaternionOf({{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}}});
  v1::Quaternion& r = *out.mutable_rotation();
  r.set_x(q[0]), r.set_y(q[1]), r.set_z(q[2]), r.set_w(q[3]);
  return out;
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

Transform product(const Transform& T_a_b, const Transform& T_b_c) {
  Transform result{};
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      for (std::size_t i = 0; i < 4; ++i)
        result[4 * row + column] += T_a_b[4 * row + i] * T_b_c[4 * i + column];
  return result;
}

Transform relative(const Transform& T_body_a, const Transform& T_body_b) {
  return product(inverse(T_body_a), T_body_b);
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
