// What the text formats share: a first line, then one line per event.
#pragma once

#include <cstddef>
#include <string>

#include "client/writers/writer.h"

namespace saccade::client {

class TextWriter : public Writer {
 public:
  using AppendLine = void (*)(std::string& text, const Event& event);

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

  const std::string path_;
  std::string text_;
  const AppendLine append_line_;
  int file_;
  std::size_t size_ = 0;  // of the whole batches in it
};

// Appends a number, padded with zeros in front to `digits`.
void appendNumber(std::string& text, std::int64_t value, int digits = 1);

}  // namespace saccade::client
