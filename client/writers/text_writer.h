// What the text formats share: a first line, then one line per event.
#pragma once

#include <cstdio>
#include <memory>
#include <string>

#include "client/writers/writer.h"

namespace saccade {

class TextWriter : public Writer {
 public:
  using AppendLine = void (*)(std::string& text, const Event& event);

  TextWriter(const std::string& path, const std::string& first_line, AppendLine append_line);
  void write(const Events& events) override;
  void finish() override;

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void writeText();
  [[noreturn]] void fail() const;

  std::string path_, text_;
  AppendLine append_line_;
  std::unique_ptr<std::FILE, Close> file_;
};

// Appends a number, padded with zeros in front to `digits`.
void appendNumber(std::string& text, std::int64_t value, int digits = 1);

}  // namespace saccade
