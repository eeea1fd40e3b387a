// A file that is read by place.
#pragma once

#include <cstdint>
#include <fstream>
#include <string>

namespace saccade::client {

class InputFile {
 public:
  // Throws std::system_error with the file's name, as does read().
  explicit InputFile(const std::string& path);

  const std::string& path() const { return path_; }
  std::uint64_t size() const { return size_; }  // bytes
  // Whether `size` bytes lie from `at` on before `end`, which is at most size().
  static bool holds(std::uint64_t at, std::uint64_t size, std::uint64_t end) {
    return at <= end && size <= end - at;
  }
  // Replaces `bytes` by `size` of them, which the file holds.
  void read(std::uint64_t at, std::uint64_t size, std::string& bytes);

 private:
  const std::string path_;
  std::ifstream file_;
  std::uint64_t size_ = 0;
};

}  // namespace saccade::client
