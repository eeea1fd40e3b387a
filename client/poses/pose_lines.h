// Lines of a file and the text of a pose, for the readers of poses.
#pragma once

#include <cstdint>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "client/calibration/rotation.h"

namespace saccade::client {

// Lines of a text file, with their numbers for errors.
class PoseLines {
 public:
  // Throws std::invalid_argument where the file cannot be read.
  explicit PoseLines(const std::string& path);

  // Replaces `words` by those of the next line; false at the end of the file.
  bool next(std::vector<std::string_view>& words);
  [[noreturn]] void fail(const std::string& what) const;  // throws std::invalid_argument
  double number(std::string_view word) const;

 private:
  const std::string path_;
  std::ifstream file_;
  std::vector<char> buffer_;
  std::uint64_t number_ = 0;  // of the line
};

// "t,x,y,z,qx,qy,qz,qw", with the time of `frame` in nanoseconds.
std::string poseText(double frame, double rate_hz, const Vector3& position, const Quaternion& rotation);

}  // namespace saccade::client
