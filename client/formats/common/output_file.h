// A file that grows to its end, or standard output.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace saccade::client {

// As a path: standard output.
inline constexpr const char* kStandardOutput = "-";

// Whether another program, or another part of this one, is writing the file.
bool isBeingWritten(const std::string& path);

// Every call throws std::system_error with the file's name when the file cannot be written.
class OutputFile {
 public:
  // An existing file is emptied, unless another program is writing it.
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  // Writes `bytes` to the end at once. If this throws, the file has no part of them.
  void append(std::string_view bytes);
  // Writes bytes at a place; not of standard output. A file that grows by this takes no append().
  void overwrite(std::uint64_t at, std::string_view bytes);
  std::uint64_t size() const { return size_; }  // bytes
  void close();                                 // the last call

 private:
  void begin();
  void takeBack();
  [[noreturn]] void fail() const;

  const std::string name_;  // for errors
  int file_;
  std::uint64_t size_ = 0;
};

}  // namespace saccade::client
