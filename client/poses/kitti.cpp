// KITTI's poses/NN.txt: the first three rows of T_world_camera in a line, row by row.
#include "client/poses/pose_formats.h"
#include "client/poses/pose_lines.h"

namespace saccade::client {
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
