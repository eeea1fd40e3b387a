#include "client/writers/text_writer.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <string_view>
#include <system_error>
#include <utility>

namespace saccade::client {
namespace {

int openFile(const std::string& path) {
  if (path == kStandardOutput) return dup(STDOUT_FILENO);
  return open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
}

}  // namespace

TextWriter::TextWriter(const std::string& path, const std::string& first_line, AppendLine append_line)
    : name_(path == kStandardOutput ? "standard output" : path),
      text_(first_line),
      append_line_(append_line),
      file_(openFile(path)) {
  if (file_ < 0) fail();
  writeText();
}

TextWriter::~TextWriter() {
  if (file_ >= 0) close(file_);
}

void TextWriter::write(const Events& events) {
  for (const Event& event : events) append_line_(text_, event);
  writeText();
}

void TextWriter::finish() {
  if (close(std::exchange(file_, -1)) != 0) fail();
}

void TextWriter::writeText() {
  for (std::string_view rest = text_; !rest.empty();) {
    const ssize_t written = ::write(file_, rest.data(), rest.size());
    if (written < 0 && errno != EINTR) takeBack();
    if (written > 0) rest.remove_prefix(static_cast<std::size_t>(written));
  }
  size_ += text_.size();
  text_.clear();
}

// Removes the part of the batch that was written, so that the file ends with a whole line.
void TextWriter::takeBack() {
  const int fault = errno;
  const bool is_file = lseek(file_, 0, SEEK_CUR) >= 0;
  if (!is_file || ftruncate(file_, static_cast<off_t>(size_)) == 0) errno = fault;
  fail();
}

void TextWriter::fail() const {
  throw std::system_error(errno, std::generic_category(), name_);
}

void appendNumber(std::string& text, std::int64_t value, int digits) {
  char buffer[24];
  const auto length = std::to_chars(buffer, buffer + sizeof(buffer), value).ptr - buffer;
  if (length < digits) text.append(digits - length, '0');
  text.append(buffer, length);
}

}  // namespace saccade::client
