// A file without a name, which is gone with its owner. It holds bytes until their place in another is known.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "client/formats/common/output_file.h"

namespace saccade::client {

// Every call throws std::system_error with `path`, the name of the other.
class SpoolFile {
 public:
  explicit SpoolFile(const std::string& path);  // in the same folder
  ~SpoolFile();
  SpoolFile(const SpoolFile&) = delete;
  SpoolFile& operator=(const SpoolFile&) = delete;

  void allocate(std::uint64_t size);  // takes that many bytes of the disk
  void write(std::uint64_t at, std::string_view bytes);
  // Moves the first `size` bytes to `target`, from the last to the first, and gives each block back to the
  // disk once it is copied. So the disk needs room for one more block only.
  void moveTo(OutputFile& target, std::uint64_t at, std::uint64_t size);

 private:
  void cutTo(std::uint64_t size);
  void read(std::uint64_t at, std::string& bytes);
  [[noreturn]] void fail(int fault) const;

  const std::string path_;
  int file_;
};

}  // namespace saccade::client
