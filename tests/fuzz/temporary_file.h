// A file for readers that take a path; in memory where there is a folder for that, and gone with its owner.
#pragma once

#include <stdlib.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "base/check.h"

namespace saccade {

class TemporaryFile {
 public:
  TemporaryFile() {
    const int file = mkstemp(path_.data());
    SACCADE_CHECK(file >= 0);
    close(file);
  }
  ~TemporaryFile() { unlink(path_.c_str()); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& path() const { return path_; }
  void replace(std::string_view bytes) const { std::ofstream(path_, std::ios::binary) << bytes; }
  std::string bytes() const {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

 private:
  static std::filesystem::path folder() {
    constexpr const char* kInMemory = "/dev/shm";
    return std::filesystem::exists(kInMemory) ? kInMemory : std::filesystem::temp_directory_path();
  }
  std::string path_ = folder() / "saccade-fuzz-XXXXXX";
};

}  // namespace saccade
