// The lines of a file of any length, one after the other.
#pragma once

#include <fstream>
#include <string>

namespace saccade::farm {

class LineFile {
 public:
  explicit LineFile(const std::string& path);  // throws std::system_error, as next() does
  // Replaces `line` by the next one, without its end. Returns false at the end of the file.
  bool next(std::string& line);

 private:
  const std::string path_;
  std::ifstream input_;
};

}  // namespace saccade::farm
