// The lines of a text file. The first can be looked at before they are taken. A line has at most 4 KiB.
#pragma once

#include <array>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "client/formats/common/reader.h"

namespace saccade::client {

// Every call throws FileFault with the number of a line that is too long, and std::system_error.
class TextLines {
 public:
  explicit TextLines(const std::string& path);

  // Takes the next line, without its end; false: there is none. The text stays until the next call.
  bool next(std::string_view& line);
  // The next lines, `count` at most. next() still gives them.
  const std::vector<std::string>& ahead(std::size_t count);
  std::uint64_t number() const { return number_; }  // of the line that was taken last, from 1

 private:
  static constexpr std::size_t kLongestLine = 4096;

  bool readLine(std::string_view& line);

  const std::string path_;
  std::ifstream file_;
  std::array<char, kLongestLine + 2> buffer_;  // with CR and an end
  std::vector<std::string> ahead_;
  std::size_t taken_ = 0;  // of those ahead
  std::uint64_t number_ = 0, read_ = 0;
};

}  // namespace saccade::client
