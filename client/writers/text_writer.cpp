#include "client/writers/text_writer.h"

#include <cerrno>
#include <charconv>
#include <system_error>

namespace saccade {

TextWriter::TextWriter(const std::string& path, const std::string& first_line, AppendLine append_line)
    : path_(path), text_(first_line), append_line_(append_line), file_(std::fopen(path.c_str(), "wb")) {
  if (!file_) fail();
  writeText();
}

void TextWriter::write(const Events& events) {
  for (const Event& event : events) append_line_(text_, event);
  writeText();
}

void TextWriter::finish() {
  if (std::fclose(file_.release()) != 0) fail();
}

void TextWriter::writeText() {
  if (std::fwrite(text_.data(), 1, text_.size(), file_.get()) != text_.size()) fail();
  text_.clear();
}

void TextWriter::fail() const {
  throw std::system_error(errno, std::generic_category(), path_);
}

void appendNumber(std::string& text, std::int64_t value, int digits) {
  char buffer[24];
  const auto length = std::to_chars(buffer, buffer + sizeof(buffer), value).ptr - buffer;
  if (length < digits) text.append(digits - length, '0');
  text.append(buffer, length);
}

}  // namespace saccade
