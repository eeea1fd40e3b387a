#include "client/formats/text/text_lines.h"

#include <cerrno>
#include <system_error>

#include "client/formats/common/bounded_line.h"

namespace saccade::client {

TextLines::TextLines(const std::string& path) : path_(path), file_(path, std::ios::binary) {
  if (!file_) throw std::system_error(errno, std::generic_category(), path);
}

bool TextLines::next(std::string_view& line) {
  ++number_;
  if (taken_ == ahead_.size()) return readLine(line);
  line = ahead_[taken_++];
  return true;
}

const std::vector<std::string>& TextLines::ahead(std::size_t count) {
  for (std::string_view line; ahead_.size() < count && readLine(line);) ahead_.emplace_back(line);
  return ahead_;
}

bool TextLines::readLine(std::string_view& line) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  ++read_;
  const LineRead read = takeLine(file_, buffer_, line);
  if (read == LineRead::kTooLong || line.size() > kLongestLine)
    throw FileFault(path_, "line " + std::to_string(read_) + " is longer than 4 KiB");
  if (file_.bad()) throw std::system_error(errno, std::generic_category(), path_);
  if (read_ == 1 && line.starts_with(kByteOrderMark)) line.remove_prefix(kByteOrderMark.size());
  return read == LineRead::kLine;
}

}  // namespace saccade::client
