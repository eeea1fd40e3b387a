#include "client/calibration/rotation.h"

#include <cmath>

namespace saccade::client {
namespace {

constexpr double kRounding = 1e-3;  // of files with few digits

double dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

bool isRotation(const Matrix3& r) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (!(std::abs(dot(r[i], r[j]) - (i == j)) < kRounding)) return false;
  return dot(cross(r[0], r[1]), r[2]) > 0;
}

// [Shepperd, "Quaternion from Rotation Matrix", 1978]: the largest part first, for the least rounding.
Quaternion quaternionOf(const Matrix3& r) {
  const double trace = r[0][0] + r[1][1] + r[2][2];
  if (trace > 0) {
    const double w = std::sqrt(1 + trace) / 2;
    return {(r[2][1] - r[1][2]) / (4 * w), (r[0][2] - r[2][0]) / (4 * w), (r[1][0] - r[0][1]) / (4 * w), w};
  }
  std::size_t i = r[1][1] > r[0][0] ? 1 : 0;
  if (r[2][2] > r[i][i]) i = 2;
  const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
  const double part = std::sqrt(1 + r[i][i] - r[j][j] - r[k][k]) / 2;
  Quaternion q{};
  q[i] = part;
  q[j] = (r[i][j] + r[j][i]) / (4 * part);
  q[k] = (r[i][k] + r[k][i]) / (4 * part);
  q[3] = (r[k][j] - r[j][k]) / (4 * part);
  return q;
}

Matrix3 matrixOf(const Quaternion& unit) {
  const auto [x, y, z, w] = unit;
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
           {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
           {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}}};
}

}  // namespace saccade::client
