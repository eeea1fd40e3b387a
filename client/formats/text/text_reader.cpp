#include "client/formats/text/text_reader.h"

#include <system_error>

#include "client/formats/common/bounded_line.h"

namespace saccade::client {
namespace {

constexpr std::size_t kBatch = 1 << 16;  // events

}  // namespace

TextReader::TextReader(const std::string& path, const char* form, ParseFirst parse_first,
                       ParseLine parse_line)
    : path_(path), form_(form), parse_line_(parse_line), file_(path, std::ios::binary) {
  if (!file_) throw std::system_error(errno, std::generic_category(), path);
  const auto size = nextLine() ? parse_first(line_) : std::nullopt;
  if (!size) fail();
  size_ = *size;
}

bool TextReader::read(Events& events) {
  events.clear();
  while (events.size() < kBatch && nextLine()) {
    const auto event = parse_line_(line_);
    if (!event) fail();
    events.push_back(*event);
  }
  return !events.empty();
}

bool TextReader::nextLine() {
  ++number_;
  const LineRead read = takeLine(file_, buffer_, line_);
  if (read == LineRead::kTooLong || line_.size() > kLongestLine)
    throw FileFault(path_, "line " + std::to_string(number_) + " is longer than 4 KiB");
  if (file_.bad()) throw std::system_error(errno, std::generic_category(), path_);
  return read == LineRead::kLine;
}

void TextReader::fail() const {
  throw FileFault(path_, "line " + std::to_string(number_) + " is not of the form " + form_);
}

}  // namespace saccade::client
