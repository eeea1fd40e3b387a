// Rotations as matrices and as quaternions.
#pragma once

#include <array>

namespace saccade::client {

using Vector3 = std::array<double, 3>;
using Matrix3 = std::array<Vector3, 3>;    // rows
using Quaternion = std::array<double, 4>;  // x y z w

bool isRotation(const Matrix3& matrix);  // to the rounding of files with few digits
Quaternion quaternionOf(const Matrix3& rotation);
Matrix3 matrixOf(const Quaternion& unit);

}  // namespace saccade::client
