// Writes a text format: a first line, then one line per event.
#pragma once

#include <cstddef>
#include <string>

#include "client/writers/writer.h"

namespace saccade::client {

class TextWriter : public Writer {
 public:
  using AppendLine = void (*)(std::string& text, const Event& event);

  // `path` as WriterInfo::make(). `first_line` ends with a line feed, or is empty.
  TextWriter(const std::string& path, const std::string& first_line, AppendLine append_line);
  ~TextWriter() override;
  TextWriter(const TextWriter&) = delete;
  TextWriter& operator=(const TextWriter&) = delete;

  void write(const Events& events) override;
  void finish() override;

 private:
  void writeText();
  void takeBack();
  [[noreturn]] void fail() const;

  const std::string name_;  // for errors
  std::string text_;
  const AppendLine append_line_;
  int file_;
  std::size_t size_ = 0;  // bytes of the batches written so far
};

// Appends a number of at least `digits` digits, with zeros in front.
void appendNumber(std::string& text, std::int64_t value, int digits = 1);

}  // namespace saccade::client
