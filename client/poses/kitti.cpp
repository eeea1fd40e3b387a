// KITTI's poses/NN.txt: the first three rows of T_world_camera in a line, row by row.
#include <cmath>

#include "client/poses/pose_formats.h"
#include "client/poses/pose_lines.h"

namespace saccade::client {
namespace {

constexpr double kRounding = 1e-3;  // of files with few digits

double dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

bool isRotation(const Matrix3& r) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (!(std::abs(dot(r[i], r[j]) - (i == j)) < kRounding)) return false;
  return dot(cross(r[0], r[1]), r[2]) > 0;
}

}  // namespace

std::string readKitti(const std::string& path, double rate_hz) {
  PoseLines lines(path);
  std::string csv;
  double frame = 0;
  for (std::vector<std::string_view> words; lines.next(words);) {
    if (words.empty()) continue;
    if (words.size() != 12)
      lines.fail("a line of " + std::to_string(words.size()) + " numbers; KITTI has 12");
    Matrix3 rotation;
    Vector3 position;
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t i = 0; i < 3; ++i) rotation[row][i] = lines.number(words[4 * row + i]);
      position[row] = lines.number(words[4 * row + 3]);
    }
    if (!isRotation(rotation)) lines.fail("the first three columns are no rotation");
    csv += poseText(frame++, rate_hz, position, quaternionOf(rotation));
  }
  return csv;
}

}  // namespace saccade::client
