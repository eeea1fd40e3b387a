// Writes a text format: a first line, then one line per event.
#pragma once

#include <string>

#include "client/formats/common/writer.h"

namespace saccade::client {

class TextWriter : public Writer {
 public:
  using AppendLine = void (*)(std::string& text, const Event& event);

  // `first_line` ends with a line feed, or is empty.
  TextWriter(const std::string& path, const std::string& first_line, AppendLine append_line);

  void write(const Events& events, std::int64_t until_ns) override;
  void finish() override { file_.close(); }

 private:
  OutputFile file_;
  std::string text_;
  const AppendLine append_line_;
};

// Appends a number of at least `digits` digits, with zeros in front.
void appendNumber(std::string& text, std::int64_t value, int digits = 1);

}  // namespace saccade::client
