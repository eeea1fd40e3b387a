#include "client/formats/text/text_writer.h"

#include <charconv>

namespace saccade::client {

TextWriter::TextWriter(const std::string& path, const std::string& first_line, AppendLine append_line)
    : file_(path), append_line_(append_line) {
  file_.append(first_line);
}

void TextWriter::write(const Events& events, std::int64_t) {
  text_.clear();
  for (const Event& event : events) append_line_(text_, event);
  file_.append(text_);
}

void appendNumber(std::string& text, std::int64_t value, int digits) {
  char buffer[24];
  const auto length = std::to_chars(buffer, buffer + sizeof(buffer), value).ptr - buffer;
  if (length < digits) text.append(digits - length, '0');
  text.append(buffer, length);
}

}  // namespace saccade::client
