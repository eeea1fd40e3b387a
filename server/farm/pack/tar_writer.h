// A tar file in the format ustar [POSIX.1-2017, pax]. Equal members give equal bytes: they have neither times
// nor owners. Names of more than 100 bytes, and members of 8 GiB and more, get an extended header of pax.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "client/formats/common/output_file.h"

namespace saccade::farm {

inline constexpr std::uint64_t kTarBlock = 512;  // bytes
inline constexpr std::uint64_t kTarEnd = 2 * kTarBlock;

// All that stands before the bytes of a member.
std::string tarHeader(const std::string& name, std::uint64_t bytes);
// The space that a member takes.
std::uint64_t tarSpace(const std::string& name, std::uint64_t bytes);

// Every call throws std::system_error with the file's name when the file cannot be written.
class TarWriter {
 public:
  explicit TarWriter(const std::string& path) : output_(path) {}
  void begin(const std::string& name, std::uint64_t bytes);
  void append(std::string_view bytes) {
    output_.append(bytes);
  }              // of the member; in all, as many as begin() says
  void end();    // of the member
  void close();  // the last call

 private:
  client::OutputFile output_;
};

}  // namespace saccade::farm
