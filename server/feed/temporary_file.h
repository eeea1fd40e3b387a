// A file that gets its name when it is complete. A lock tells it from those that killed programs have left.
#pragma once

#include <cstddef>
#include <string>

namespace saccade {

// Every call throws std::system_error with the file's name.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& path);  // the later name; this one has six letters more
  ~TemporaryFile();                                 // removes it, unless it has its name
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void write(const void* data, std::size_t size);
  // Gives it its name, in place of any file there, once it is on the disk.
  void keep();

 private:
  bool create();
  void check(bool done) const;

  const std::string path_;
  std::string name_;
  int file_ = -1;
};

// Removes such a file, unless a program is writing it.
void removeLeftover(const std::string& file);

}  // namespace saccade
